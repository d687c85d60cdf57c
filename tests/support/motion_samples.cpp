#include "support/motion_samples.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "support/golden_section.h"

namespace clearway::testing {

namespace ob = ompl::base;

void MotionSamples::take(int poses, double until) {
    all_.reserve(2 * static_cast<std::size_t>(poses));
    for (int i = 0; i <= poses; ++i) look(double(i) / poses);
    for (const double time : {kJustAfterStart, kJustBeforeEnd, until}) look(time);
    const int near = poses / 20;
    for (int i = 1; i <= near; ++i) {
        const double away = until * std::pow(0.5, 50.0 * i / near);
        look(std::min(away, kJustBeforeEnd));
        look(until - away);
    }
    const auto clearanceAt = [this](double time) { return look(time).clearance; };
    searchLeast(clearanceAt, worst(until).time, 1.0 / poses, until);
    std::sort(all_.begin(), all_.end(),
              [](const MotionSample& a, const MotionSample& b) { return a.time < b.time; });
}

MotionSample MotionSamples::look(double time) {
    const ob::State* state = stateAt(time);
    const MotionSample sample{time, scene_.checker->clearance(state), scene_.checker->isValid(state)};
    if (sample.isValid != (sample.clearance > 0)) BOOST_ERROR("isValid contradicts clearance at " << time);
    all_.push_back(sample);
    return sample;
}

const ob::State* MotionSamples::stateAt(double time) {
    if (time == 0 || time == 1) return time == 0 ? s1_ : s2_;
    scene_.space->interpolate(s1_, s2_, time, between_.get());
    return between_.get();
}

MotionSample MotionSamples::worst(double until) const {
    MotionSample result{0, std::numeric_limits<double>::infinity(), true};
    for (const MotionSample& sample : all_) {
        if (sample.time > until) continue;
        if (sample.clearance < result.clearance) result = sample;
        if (!sample.isValid) return sample;
    }
    return result;
}

/// How far, in displacement, a pose is from the border. Within the doubt, validators cannot tell its side.
double MotionSamples::fromBorder(const ContactZone& zone, double time) {
    constexpr double kDoubt = 1e-5;  // share of the zone's length
    const Pose X_environmentPart = scene_.checker->pose(stateAt(time));
    const double moved = scene_.scene.part.displacement(zone.X_environmentPart, X_environmentPart);
    const double doubt = 2 * scene_.validator->leastInterval() + kDoubt * zone.distance;
    return std::max(0.0, std::abs(moved - zone.distance) - doubt);
}

bool MotionSamples::isAtZoneBorder(double time) {
    for (const auto& zone : {scene_.scene.startContact, scene_.scene.goalContact}) {
        if (zone && fromBorder(*zone, time) == 0) return true;
    }
    return false;
}

bool MotionSamples::isSomewhereAtZoneBorder() {
    for (const auto& zone : {scene_.scene.startContact, scene_.scene.goalContact}) {
        if (!zone) continue;
        const auto distanceAt = [&](double time) { return fromBorder(*zone, time); };
        double nearest = 0;
        for (const MotionSample& sample : all_) {
            if (distanceAt(sample.time) < distanceAt(nearest)) nearest = sample.time;
        }
        if (searchLeast(distanceAt, nearest, 1.0 / static_cast<double>(all_.size()), 1) == 0) return true;
    }
    return false;
}

}  // namespace clearway::testing
