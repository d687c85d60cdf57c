#include "program/render/ink_mask.h"

#include <cairo/cairo-ft.h>

#include <cmath>
#include <stdexcept>

#include "core/embed.h"

CLEARWAY_EMBED(clearwayFont, CLEARWAY_FONT)  // whole: the file holds its licence

namespace clearway::render {
namespace {

constexpr double kFigureHeight = 0.73;  ///< height of a digit per font size

/// The font that the program carries.
struct EmbeddedFont {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    cairo_font_face_t* cairoFace = nullptr;

    EmbeddedFont() {
        if (FT_Init_FreeType(&library) != 0 ||
            FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(clearwayFont),
                               clearwayFontEnd - clearwayFont, 0, &face) != 0) {
            throw std::runtime_error("FreeType cannot read the font of the program");
        }
        cairoFace = cairo_ft_font_face_create_for_ft_face(face, 0);
    }
};

/// Lives as long as the program: Cairo keeps what it made of the font until then.
cairo_font_face_t* legendFace() {
    static const EmbeddedFont* const font = new EmbeddedFont();
    return font->cairoFace;
}

}  // namespace

InkMask::InkMask(int left, int width, int height)
    : left_(left),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_A8, width - left, height), cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_translate(context_.get(), -left, 0);
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_font_face(context_.get(), legendFace());
    // Without hinting, text grows evenly with its height, and so fits where its measured width says.
    cairo_font_options_t* const options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context_.get(), options);
    cairo_font_options_destroy(options);
}

void InkMask::drawLine(double fromX, double fromY, double toX, double toY, double width) {
    cairo_set_line_width(context_.get(), width);
    cairo_move_to(context_.get(), fromX, fromY);
    cairo_line_to(context_.get(), toX, toY);
    cairo_stroke(context_.get());
}

void InkMask::drawFrame(const Area& area, double width) {
    cairo_set_line_width(context_.get(), width);
    cairo_rectangle(context_.get(), area.left, area.top, area.right - area.left, area.bottom - area.top);
    cairo_stroke(context_.get());
}

void InkMask::fillBox(const Area& area) {
    cairo_rectangle(context_.get(), area.left, area.top, area.right - area.left, area.bottom - area.top);
    cairo_fill(context_.get());
}

void InkMask::keepWithin(const Area& area) {
    cairo_rectangle(context_.get(), area.left, area.top, area.right - area.left, area.bottom - area.top);
    cairo_clip(context_.get());
}

void InkMask::drawCircle(double x, double y, double radius, double width) {
    cairo_set_line_width(context_.get(), width);
    cairo_new_sub_path(context_.get());
    cairo_arc(context_.get(), x, y, radius, 0, 2 * M_PI);
    cairo_stroke(context_.get());
}

void InkMask::drawText(const std::string& text, double x, double y, double height) {
    cairo_set_font_size(context_.get(), height / kFigureHeight);
    cairo_move_to(context_.get(), x, y);
    cairo_show_text(context_.get(), text.c_str());
}

double InkMask::widthOf(const std::string& text, double height) const {
    cairo_set_font_size(context_.get(), height / kFigureHeight);
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), text.c_str(), &extents);
    return extents.x_bearing + extents.width;
}

void InkMask::layOver(Image& image, const Colour& colour) const {
    if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error(std::string("Cairo cannot draw on the picture: ") +
                                 cairo_status_to_string(cairo_status(context_.get())));
    }
    cairo_surface_flush(surface_.get());
    const unsigned char* row = cairo_image_surface_get_data(surface_.get());
    for (int y = 0; y < image.height; ++y, row += cairo_image_surface_get_stride(surface_.get())) {
        for (int x = left_; x < image.width; ++x) {
            const float ink = static_cast<float>(row[x - left_]) / 255;
            image.at(x, y) += ink * (colour - image.at(x, y));
        }
    }
}

}  // namespace clearway::render
