#include "drawing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "document/letters.hpp"
#include "paper.hpp"

namespace blossom::worked {

namespace {

void append_segments(std::vector<Segment>& segments, const std::vector<Spot>& spots) {
    for (std::size_t i = 0; i + 1 < spots.size(); ++i) segments.push_back({spots[i], spots[i + 1]});
}

bool has_name(const PicturePoint& point) {
    return point.label.kind != FormulaKind::words || !point.label.name.empty();
}

/// Points at one place have one dot, of the most important role, and one label with all their names.
void add_points(const Picture& picture, const Paper& paper, const Notation& notation, Drawing& drawing) {
    for (const PicturePoint& point : picture.points) {
        const Spot spot = paper.spot(point.place);
        const auto same = std::ranges::find(drawing.dots, spot, &Drawing::Dot::spot);
        if (same == drawing.dots.end()) {
            drawing.dots.push_back({spot, point.role});
            auto& names = drawing.labels.emplace_back().names;
            if (has_name(point)) names.push_back(point.label);
            continue;
        }
        auto& names = drawing.labels[static_cast<std::size_t>(same - drawing.dots.begin())].names;
        const auto text = [&](const Formula& name) { return to_text(name, notation); };
        const bool is_new = std::ranges::find(names, text(point.label), text) == names.end();
        if (has_name(point) && is_new) names.push_back(point.label);
        same->role = std::max(same->role, point.role);
    }
}

/// Whether labels of this role are set in bold.
bool bold(Role role) { return role == Role::result || role == Role::second; }

void add_labels(Drawing& drawing, const Box& room, const Notation& notation) {
    std::vector<Segment> segments;
    for (const Drawing::Path& path : drawing.paths)
        append_segments(segments, path.cubic ? flattened(path.spots) : path.spots);
    std::vector<LabelSize> sizes;
    std::vector<Drawing::Label*> named;
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
        if (drawing.labels[i].names.empty()) continue;
        const std::string text = to_text(label_formula(drawing.labels[i]), notation);
        sizes.push_back({drawing.dots[i].spot, text_width(text, bold(drawing.dots[i].role)), label_height});
        named.push_back(&drawing.labels[i]);
    }
    const std::vector<PlacedLabel> placed = place_labels(sizes, segments, room);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        named[i]->box = placed[i].box;
        if (placed[i].away) named[i]->leader = leader(sizes[i].anchor, placed[i].box);
    }
}

/// The names of curves above the picture.
void add_legend(const Picture& picture, const Box& room, Drawing& drawing) {
    Length x = room.left + 60;
    for (const PictureCurve& curve : picture.curves) {
        if (curve.name.empty()) continue;
        drawing.legend.push_back({{{x, room.top + 100}, {x + 200, room.top + 100}}, curve});
        x += 400 + text_width(curve.name);
    }
}

}  // namespace

Length text_width(std::string_view text, bool bold) {
    struct Kind {
        std::string_view characters;
        Length width;
    };
    // As wide as in DejaVu Sans of 15 pixels, the widest of the fonts that the pictures name.
    static constexpr std::array<Kind, 3> kinds{{{" ,.'/", 51}, {"()[]", 61}, {"=+<>mwMW", 130}}};
    constexpr Length other = 96;
    constexpr Length margin = 20;
    Length width = margin + other * static_cast<Length>(columns(text));
    for (const Kind& kind : kinds) {
        const auto found = std::ranges::count_if(
            text, [&](char c) { return kind.characters.find(c) != std::string_view::npos; });
        width += (kind.width - other) * static_cast<Length>(found);
    }
    return bold ? width * 9 / 8 : width;
}

Formula label_formula(const Drawing::Label& label) {
    const bool relations = std::ranges::any_of(
        label.names, [](const Formula& name) { return name.kind == FormulaKind::relation; });
    return relations ? list_of(label.names) : equation(label.names);
}

std::string pixels(Length length) {
    const std::string sign = length < 0 ? "-" : "";
    const Length size = length < 0 ? -length : length;
    const std::string whole = sign + std::to_string(size / 10);
    return size % 10 == 0 ? (whole == "-0" ? "0" : whole) : whole + "." + std::to_string(size % 10);
}

Drawing drawn(const Picture& picture, const Notation& notation) {
    const Paper paper(picture);
    Drawing drawing;
    drawing.width = paper.width();
    drawing.height = paper.height();
    drawing.axes = paper.axes();
    drawing.ticks = paper.ticks();
    for (const PictureLine& line : picture.lines) {
        drawing.paths.push_back({paper.spots(line.places), false, line.role, false});
    }
    for (const PictureCurve& curve : picture.curves) {
        drawing.paths.push_back({paper.spots(curve.places), curve.cubic, curve.role, true});
    }
    for (const PictureFace& face : picture.faces) drawing.faces.push_back({paper.spots(face.places), face});
    for (const PictureWords& words : picture.words) drawing.words.push_back({paper.spot(words.place), words});
    add_points(picture, paper, notation, drawing);
    Box room = paper.room();
    add_legend(picture, room, drawing);
    if (!drawing.legend.empty()) room.top += label_height;
    add_labels(drawing, room, notation);
    return drawing;
}

}  // namespace blossom::worked
