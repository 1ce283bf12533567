#include <blossom/protocol/answer.hpp>
#include <blossom/protocol/pack.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <fmt/format.h>
#include <boost/crc.hpp>

#include <algorithm>
#include <random>
#include <utility>

#include "formats/doubles.hpp"
#include "json/json_text.hpp"
#include "json/nearest_name.hpp"
#include "responses.hpp"
#include "rounding.hpp"

namespace blossom::protocol {

namespace {

/// What makes the arithmetic of a case hard.
enum class Difficulty { ordinary, cancellation, ratios, close_knots, repeated_knots };

constexpr std::string_view difficulty_names[] = {"ordinary", "cancellation", "ratios", "close knots",
                                                 "repeated knots"};

/// Random numbers that are doubles, the same on every machine: the standard fixes the engine.
class DoubleNumbers {
public:
    explicit DoubleNumbers(std::uint64_t seed) : engine_(seed) {}

    Difficulty difficulty = Difficulty::ordinary;

    std::int64_t between(std::int64_t least, std::int64_t greatest) {
        return least +
               static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(greatest - least + 1));
    }
    std::size_t count(std::size_t least, std::size_t greatest) {
        return least + static_cast<std::size_t>(engine_() % (greatest - least + 1));
    }
    bool chance() { return engine_() % 2 == 0; }

    /// A coordinate of a point.
    Rational coordinate() {
        const Rational small(between(-1024, 1024), Integer(1) << between(0, 8));
        switch (difficulty) {
            case Difficulty::cancellation:
                return (chance() ? 1 : -1) * pow(Rational(2), 40) + small;
            case Difficulty::ratios:
                return small * pow(Rational(2), between(-100, 100));
            default:
                return small;
        }
    }
    Rational weight() {
        const Rational weight(between(1, 64), 8);
        return difficulty == Difficulty::ratios ? weight * pow(Rational(2), between(-20, 20)) : weight;
    }
    /// A number in [0, 1], sometimes very near to an end.
    Rational parameter() {
        const Rational near = pow(Rational(2), -between(20, 50));
        switch (count(0, 7)) {
            case 0:
                return near;
            case 1:
                return 1 - near;
            default:
                return {between(0, 64), 64};
        }
    }
    /// A number in [a, b] with a few binary digits beyond those of the ends.
    Rational inside(const Rational& a, const Rational& b) {
        return a + Rational(between(0, 16), 16) * (b - a);
    }
    /// The step to the next knot.
    Rational step() {
        if (difficulty == Difficulty::close_knots && chance()) return pow(Rational(2), -between(20, 40));
        return {between(1, 8), 8};
    }

private:
    std::mt19937_64 engine_;
};

Json number(const Rational& value) { return double_number(value); }

Json numbers(const std::vector<Rational>& values) { return mapped(values, number); }

Json points(DoubleNumbers& draw, std::size_t count, std::size_t dimension) {
    Json::Array list;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<Rational> point;
        for (std::size_t j = 0; j < dimension; ++j) point.push_back(draw.coordinate());
        list.push_back(numbers(point));
    }
    return list;
}

Json parameters(DoubleNumbers& draw, std::size_t count) {
    Json::Array list;
    for (std::size_t i = 0; i < count; ++i) list.push_back(number(draw.parameter()));
    return list;
}

Json bezier(DoubleNumbers& draw, std::size_t dimension) {
    return Json::Object{{"kind", "bezier"}, {"control_points", points(draw, draw.count(2, 9), dimension)}};
}

/// A spline and its knots.
struct RandomSpline {
    Json map;
    std::vector<Rational> knots;
    std::size_t degree;

    Rational begin() const { return knots[degree]; }
    Rational end() const { return knots[knots.size() - degree - 1]; }
};

RandomSpline spline(DoubleNumbers& draw, bool weighted) {
    const std::size_t degree = draw.count(1, 5);
    const std::size_t count = degree + draw.count(1, 6);
    const bool clamped = draw.difficulty != Difficulty::ordinary || draw.chance();
    std::vector<Rational> knots{draw.between(-4, 4)};
    std::size_t multiplicity = 1;
    for (std::size_t i = 1; i < count + degree + 1; ++i) {
        const bool at_end = clamped && (i <= degree || i > count);
        const bool again = draw.difficulty == Difficulty::repeated_knots && multiplicity < degree &&
                           i != count && draw.chance();
        multiplicity = at_end || again ? multiplicity + 1 : 1;
        knots.push_back(multiplicity > 1 ? knots.back() : knots.back() + draw.step());
    }
    Json::Object map{{"kind", "bspline"},
                     {"degree", degree},
                     {"knots", numbers(knots)},
                     {"control_points", points(draw, count, draw.count(1, 3))}};
    if (weighted) {
        std::vector<Rational> weights;
        for (std::size_t i = 0; i < count; ++i) weights.push_back(draw.weight());
        map.emplace_back("weights", numbers(weights));
    }
    return {std::move(map), std::move(knots), degree};
}

Json inside(DoubleNumbers& draw, const RandomSpline& spline, std::size_t count) {
    std::vector<Rational> list;
    for (std::size_t i = 0; i < count; ++i) list.push_back(draw.inside(spline.begin(), spline.end()));
    return numbers(list);
}

Json::Object evaluate_case(DoubleNumbers& draw, const Limits&) {
    return {{"op", "evaluate"}, {"map", bezier(draw, draw.count(1, 3))}, {"at", parameters(draw, 4)}};
}

Json::Object blossom_case(DoubleNumbers& draw, const Limits&) {
    Json map = bezier(draw, draw.count(1, 3));
    const std::size_t degree = map.find("control_points")->array()->size() - 1;
    Json::Array arguments;
    for (std::size_t i = 0; i < degree; ++i) {
        const Json parameter = number(draw.parameter());
        arguments.push_back(draw.count(0, 4) == 0 ? Json(Json::Object{{"vector", parameter}}) : parameter);
    }
    return {{"op", "blossom"}, {"map", std::move(map)}, {"arguments", std::move(arguments)}};
}

Json::Object derivative_case(DoubleNumbers& draw, const Limits&) {
    return {{"op", "derivative"},
            {"map", bezier(draw, draw.count(1, 3))},
            {"order", draw.count(1, 3)},
            {"at", parameters(draw, 4)}};
}

Json::Object subdivide_case(DoubleNumbers& draw, const Limits&) {
    const Rational middle(draw.between(1, 63), 64);
    return {{"op", "subdivide"}, {"map", bezier(draw, draw.count(1, 3))}, {"at", number(middle)}};
}

Json::Object elevate_case(DoubleNumbers& draw, const Limits&) {
    return {{"op", "elevate"}, {"map", bezier(draw, draw.count(1, 3))}, {"by", draw.count(1, 3)}};
}

Json::Object spline_case(DoubleNumbers& draw, const Limits&) {
    RandomSpline curve = spline(draw, false);
    Json at = inside(draw, curve, 4);
    return {{"op", "evaluate"}, {"map", std::move(curve.map)}, {"at", std::move(at)}};
}

Json::Object nurbs_case(DoubleNumbers& draw, const Limits&) {
    RandomSpline curve = spline(draw, true);
    Json at = inside(draw, curve, 4);
    return {{"op", "evaluate"}, {"map", std::move(curve.map)}, {"at", std::move(at)}};
}

/// Different knots inside the domain that are none of the spline.
std::vector<Rational> new_knots(DoubleNumbers& draw, const RandomSpline& curve, std::size_t count) {
    std::vector<Rational> list;
    while (list.size() < count) {
        const Rational knot =
            curve.begin() + Rational(draw.between(1, 1023), 1024) * (curve.end() - curve.begin());
        const auto has = [&](const std::vector<Rational>& knots) {
            return std::ranges::find(knots, knot) != knots.end();
        };
        if (!has(curve.knots) && !has(list)) list.push_back(knot);
    }
    return list;
}

Json::Object insert_knots_case(DoubleNumbers& draw, const Limits&) {
    RandomSpline curve = spline(draw, draw.chance());
    Json knots = numbers(new_knots(draw, curve, draw.count(1, 4)));
    return {{"op", "insert-knots"}, {"map", std::move(curve.map)}, {"knots", std::move(knots)}};
}

/// The exact result of a request. Errors: that of the response.
Json result_of(const Json& request, const Limits& limits) {
    const ResourceBudget budget(limits);
    Answer answer = find_answer(request, limits);
    return std::move(answer.result);
}

/// A knot that was inserted exactly is removed again.
Json::Object remove_knot_case(DoubleNumbers& draw, const Limits& limits) {
    RandomSpline curve = spline(draw, false);
    const Json knot = number(new_knots(draw, curve, 1).front());
    Json inserted = result_of(Json::Object{{"op", "insert-knots"},
                                           {"map", std::move(curve.map)},
                                           {"knots", Json::Array{knot}},
                                           {"floats", "double"}},
                              limits);
    return {{"op", "remove-knot"}, {"map", std::move(inserted["map"])}, {"knot", knot}};
}

Json::Object triangle_case(DoubleNumbers& draw, const Limits&) {
    const std::size_t degree = draw.count(1, 6);
    const std::size_t dimension = draw.count(1, 3);
    Json::Array net;
    for (std::size_t i = 0; i <= degree; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const std::size_t index[] = {degree - i, i - j, j};
            net.push_back(Json::Array{mapped(index, [](std::size_t k) { return Json(k); }),
                                      points(draw, 1, dimension).array()->front()});
        }
    }
    Json::Array at;
    for (std::size_t i = 0; i < 4; ++i) {
        const Rational u = draw.parameter();
        const Rational v = (1 - u) * Rational(draw.between(0, 4), 4);
        at.push_back(numbers({1 - u - v, u, v}));
    }
    return {{"op", "evaluate"},
            {"map", Json::Object{{"kind", "simplex"}, {"degree", degree}, {"control_net", std::move(net)}}},
            {"at", std::move(at)}};
}

Json::Object tensor_case(DoubleNumbers& draw, const Limits&) {
    const std::size_t degrees[] = {draw.count(1, 4), draw.count(1, 4)};
    Json::Array at;
    for (std::size_t i = 0; i < 4; ++i) at.push_back(parameters(draw, 2));
    const std::size_t dimension = draw.count(1, 3);
    Json::Array rows;
    for (std::size_t i = 0; i <= degrees[0]; ++i) rows.push_back(points(draw, degrees[1] + 1, dimension));
    return {{"op", "evaluate"},
            {"map", Json::Object{{"kind", "tensor"},
                                 {"degrees", mapped(degrees, [](std::size_t k) { return Json(k); })},
                                 {"control_net", std::move(rows)}}},
            {"at", std::move(at)}};
}

Json::Object roots_case(DoubleNumbers& draw, const Limits&) {
    const std::size_t degree = draw.count(1, 8);
    std::vector<Rational> control_points;
    for (std::size_t i = 0; i <= degree; ++i) control_points.push_back(draw.coordinate());
    if (std::ranges::all_of(control_points, &Rational::is_zero)) control_points.front() = 1;
    return {{"op", "roots"},
            {"map", Json::Object{{"kind", "bezier"}, {"control_points", numbers(control_points)}}}};
}

struct Family {
    std::string_view name;
    bool has_knots;
    Json::Object (*draw)(DoubleNumbers& draw, const Limits& limits);
};

constexpr Family families[] = {{"evaluate", false, evaluate_case},
                               {"blossom", false, blossom_case},
                               {"derivative", false, derivative_case},
                               {"subdivide", false, subdivide_case},
                               {"elevate", false, elevate_case},
                               {"spline", true, spline_case},
                               {"nurbs", true, nurbs_case},
                               {"insert-knots", true, insert_knots_case},
                               {"remove-knot", true, remove_knot_case},
                               {"triangle", false, triangle_case},
                               {"tensor", false, tensor_case},
                               {"roots", false, roots_case}};

const Family& find_family(std::string_view name) {
    const auto* found = std::ranges::find(families, name, &Family::name);
    if (found != std::end(families)) return *found;
    const std::vector<std::string_view> names = pack_families();
    throw Error(ErrorCode::unknown_field, "the family " + quoted(name) + " is not known" +
                                              suggestion(name, names) + "; known are: " + joined(names));
}

}  // namespace

std::vector<std::string_view> pack_families() { return mapped(families, &Family::name); }

void write_pack(const Pack& pack, const Limits& limits, const std::function<void(std::string_view)>& line) {
    const Family& family = find_family(pack.family);
    boost::crc_32_type checksum;
    std::size_t lines = 0;
    const auto write = [&](Json::Object members) {
        const std::string text = to_text(Json(std::move(members)));
        checksum.process_bytes(text.data(), text.size());
        checksum.process_byte('\n');
        ++lines;
        line(text);
    };
    write({{"pack", family.name},
           {"version", std::size_t{1}},
           {"seed", Json::Number{std::to_string(pack.seed)}},
           {"cases", pack.cases}});
    DoubleNumbers draw(pack.seed);
    const std::size_t difficulties = family.has_knots ? std::size(difficulty_names) : 3;
    for (std::size_t i = 0; i < pack.cases; ++i) {
        draw.difficulty = static_cast<Difficulty>(i % difficulties);
        Json::Object request = family.draw(draw, limits);
        request.emplace_back("floats", "double");
        Json result = result_of(request, limits);
        add_rounded_numbers(result, Rounding::binary64);
        add_rounded_numbers(result, Rounding::hexadecimal);
        write({{"case", i},
               {"difficulty", difficulty_names[i % difficulties]},
               {"request", std::move(request)},
               {"result", std::move(result)}});
    }
    const std::string crc = fmt::format("{:08x}", checksum.checksum());
    line(to_text(Json(Json::Object{{"lines", lines}, {"crc32", crc}})));
}

}  // namespace blossom::protocol
