#include "axes.hpp"

#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/number_text.hpp>

namespace blossom::protocol {

namespace {

constexpr std::string_view tick_colour = "#5f6368";

void grid_line(SvgDocument& svg, const std::string& x1, const std::string& y1, const std::string& x2,
               const std::string& y2, bool axis) {
    svg.add("line", {{"x1", x1},
                     {"y1", y1},
                     {"x2", x2},
                     {"y2", y2},
                     {"stroke", axis ? "#bdc1c6" : "#eceff1"},
                     {"stroke-width", "1"}});
}

}  // namespace

std::string tick_text(const Rational& tick) {
    constexpr std::size_t longest = 8;
    const std::string fraction = to_string(tick);
    return fraction.size() <= longest ? fraction : fmt::format("{:.4g}", nearest_double(tick));
}

void paint_axes(SvgDocument& svg, const Frame& frame) {
    const std::string bottom = std::to_string(frame.height() - Frame::margin / 2);
    const std::string left = std::to_string(Frame::margin - 10);
    for (const Rational& tick : frame.ticks_of_x()) {
        grid_line(svg, frame.x(tick), "24", frame.x(tick), bottom, tick.is_zero());
        svg.add("text",
                {{"x", frame.x(tick)},
                 {"y", bottom},
                 {"dy", "14"},
                 {"text-anchor", "middle"},
                 {"fill", std::string(tick_colour)}},
                tick_text(tick));
    }
    for (const Rational& tick : frame.ticks_of_y()) {
        grid_line(svg, left, frame.y(tick), std::to_string(frame.width() - 24), frame.y(tick),
                  tick.is_zero());
        svg.add("text",
                {{"x", left},
                 {"y", frame.y(tick)},
                 {"dx", "-4"},
                 {"dy", "4"},
                 {"text-anchor", "end"},
                 {"fill", std::string(tick_colour)}},
                tick_text(tick));
    }
}

}  // namespace blossom::protocol
