#include "torture/figures.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "core/replace_file.h"
#include "support/query_cases.h"

namespace clearway::testing {
namespace {

template <typename Count>
double percent(Count part, std::uint64_t whole) {
    return whole == 0 ? 0 : 100.0 * double(part) / double(whole);
}

void keepLarger(double& worst, long double value) {
    worst = std::max(worst, static_cast<double>(value));
}

std::string shares(const std::array<std::uint64_t, kStages>& stages) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : stages) all += count;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1);
    for (int stage = 0; stage < kStages; ++stage) {
        text << (stage == 0 ? "" : "/") << percent(stages[stage], all);
    }
    return text.str();
}

/// Columns under a heading, the first one left-aligned.
class Table {
  public:
    explicit Table(std::vector<std::string> heading) { rows_.push_back(std::move(heading)); }

    template <typename... Cells>
    void add(const Cells&... cells) {
        rows_.push_back({text(cells)...});
    }

    void print(std::ostream& out) const {
        for (const auto& row : rows_) {
            for (std::size_t column = 0; column < row.size(); ++column) {
                std::size_t width = 0;
                for (const auto& other : rows_) width = std::max(width, other[column].size());
                out << (column == 0 ? std::left : std::right) << std::setw(int(width)) << row[column]
                    << (column + 1 < row.size() ? "  " : "\n");
            }
        }
    }

  private:
    template <typename Cell>
    static std::string text(const Cell& cell) {
        std::ostringstream out;
        out << std::setprecision(3) << cell;
        return out.str();
    }
    std::vector<std::vector<std::string>> rows_;
};

/// Writes the counted figures of a group as rows of the CSV.
class Rows {
  public:
    Rows(std::ostream& out, const std::string& group) : out_(out), group_(group) { out_.precision(17); }
    void family(const std::string& name) { family_ = name; }
    template <typename Value>
    void add(const std::string& figure, const Value& value) {
        out_ << group_ << ',' << family_ << ',' << figure << ',' << value << '\n';
    }
    void add(const std::string& query, const std::array<std::uint64_t, kStages>& stages) {
        const char* const names[kStages] = {"float", "double", "double-double", "exact"};
        for (int stage = 0; stage < kStages; ++stage)
            add(query + " decided in " + names[stage], stages[stage]);
    }
    void add(const FclFigures& fcl) {
        add("FCL worst error over scene", fcl.worstOfScene);
        add("FCL contact not seen by collide", fcl.freeByCollide);
        add("FCL contact not seen by distance", fcl.freeByDistance);
        add("FCL distance too large by over 1e-6 of scene", fcl.tooFar);
        add("FCL no answer", fcl.noAnswer);
    }

  private:
    std::ostream& out_;
    std::string group_, family_;
};

void addRows(Rows& rows, const PairFigures& figures) {
    rows.family(figures.family);
    rows.add("pairs", figures.pairs);
    rows.add("touching", figures.touching);
    rows.add("refused for sizes too unequal", figures.refused);
    rows.add("violations", figures.violations);
    rows.add("worst error over u64 (M + L)", figures.worstError);
    rows.add("worst error over scene", figures.worstErrorOfScene);
    rows.add("widest interval over allowed", figures.widest);
    rows.add("widest interval over scene", figures.widestOfScene);
    rows.add("double finish at height/length >= 0.01: pairs", figures.regularFinish.pairs);
    rows.add("double finish at height/length >= 0.01: worst error over u64 (M + L)",
             figures.regularFinish.error);
    rows.add("double finish at height/length >= 0.01: widest over u64 (M + L)", figures.regularFinish.width);
    rows.add("double finish of flatter ones: pairs", figures.flatFinish.pairs);
    rows.add("double finish of flatter ones: worst error over u64 (M + L)", figures.flatFinish.error);
    rows.add("double finish of flatter ones: widest over u64 (M + L)", figures.flatFinish.width);
    rows.add("distance", figures.distanceStages);
    rows.add("collides", figures.collidesStages);
    rows.add("isWithin at the truth", figures.withinStages);
    rows.add(figures.fcl);
}

}  // namespace

void FclFigures::add(double distance, bool collides, double truth, double sceneSize) {
    if (truth == 0 && !collides) ++freeByCollide;
    if (std::isnan(distance)) {
        ++noAnswer;
        return;
    }
    distance = std::max(distance, 0.0);
    if (truth == 0 && distance > 0) ++freeByDistance;
    if (distance > truth + 1e-6 * sceneSize) ++tooFar;
    if (sceneSize > 0) worstOfScene = std::max(worstOfScene, std::abs(distance - truth) / sceneSize);
}

void PairFigures::add(const CheckedCase& checked) {
    ++pairs;
    if (!checked.complaints.empty()) ++violations;
    if (checked.isRefused) {
        ++refused;
        return;
    }
    if (checked.truth == 0) ++touching;
    const CaseLengths& lengths = checked.lengths;
    const long double roundoff = static_cast<long double>(kUnitRoundoff) * (lengths.largest + lengths.edge);
    if (!(roundoff > 0)) return;  // all corners lie in the origin
    keepLarger(worstError, checked.error / roundoff);
    keepLarger(widest, checked.width / checked.allowedWidth);
    if (lengths.scene > 0) {
        keepLarger(worstErrorOfScene, checked.error / lengths.scene);
        keepLarger(widestOfScene, checked.width / lengths.scene);
    }
    ++distanceStages[int(checked.ofDistance)];
    ++collidesStages[int(checked.ofCollides)];
    for (const Stage stage : checked.ofWithin) ++withinStages[int(stage)];
    if (!checked.finish.isAsked) return;
    WorstFinish& finish = lengths.flattest >= kRegularFlatness ? regularFinish : flatFinish;
    ++finish.pairs;
    keepLarger(finish.error, checked.finish.error / roundoff);
    keepLarger(finish.width, checked.finish.width / roundoff);
}

void MeshFigures::add(const CheckedPose& checked, double sceneSize) {
    ++poses;
    if (checked.touches) ++touching;
    if (!checked.touches && checked.distance < 1e-12 * sceneSize) ++verge;
    if (checked.falseValid) ++falseValid;
    if (!checked.complaints.empty()) ++violations;
}

void print(std::ostream& out, const std::vector<PairFigures>& all) {
    if (all.empty()) return;
    Table answers({"pairs", "number", "touch", "refused", "violations", "error/u(M+L)", "/scene",
                   "widest/allowed", "/scene", "finish error", "flatter"});
    Table stages(
        {"decided in float/double/double-double/exact %", "distance", "collides", "isWithin the truth"});
    Table fcl({"FCL on the same pairs", "worst error/scene", "contact: collide no", "distance > 0",
               "distance too large", "no answer"});
    for (const PairFigures& f : all) {
        answers.add(f.family, f.pairs, f.touching, f.refused, f.violations, f.worstError, f.worstErrorOfScene,
                    f.widest, f.widestOfScene, f.regularFinish.error, f.flatFinish.error);
        stages.add(f.family, shares(f.distanceStages), shares(f.collidesStages), shares(f.withinStages));
        fcl.add(f.family, f.fcl.worstOfScene, f.fcl.freeByCollide, f.fcl.freeByDistance, f.fcl.tooFar,
                f.fcl.noAnswer);
    }
    for (const Table& table : {answers, stages, fcl}) {
        table.print(out);
        out << '\n';
    }
}

void print(std::ostream& out, const std::vector<MeshFigures>& all) {
    if (all.empty()) return;
    Table table({"meshes", "poses", "touch", "verge", "violations", "false valid", "FCL: worst error/scene",
                 "contact: collide no", "distance > 0", "distance too large"});
    for (const MeshFigures& f : all) {
        table.add(f.family, f.poses, f.touching, f.verge, f.violations, f.falseValid, f.fcl.worstOfScene,
                  f.fcl.freeByCollide, f.fcl.freeByDistance, f.fcl.tooFar);
    }
    table.print(out);
}

void writeCsv(const std::string& file, const std::vector<PairFigures>& pairs,
              const std::vector<MeshFigures>& meshes) {
    replaceFile(file, [&](std::ostream& out) {
        out << "group,family,figure,value\n";
        Rows ofPairs(out, "pairs"), ofMeshes(out, "meshes");
        for (const PairFigures& figures : pairs) addRows(ofPairs, figures);
        for (const MeshFigures& figures : meshes) {
            ofMeshes.family(figures.family);
            ofMeshes.add("poses", figures.poses);
            ofMeshes.add("touching", figures.touching);
            ofMeshes.add("free but nearer than 1e-12 of scene", figures.verge);
            ofMeshes.add("violations", figures.violations);
            ofMeshes.add("false valid", figures.falseValid);
            ofMeshes.add(figures.fcl);
        }
    });
}

}  // namespace clearway::testing
