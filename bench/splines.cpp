// B-spline curves of ten segments: with knots 0, 1, ... at a thousand parameters; and with rational knots, at
// parameters in turn and under knot insertion.

#include <blossom/core/spline/curve_values.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/knot_insertion.hpp>

#include <algorithm>
#include <memory>

#include "boost_numbers.hpp"
#include "cases.hpp"
#include "families.hpp"
#include "flint_spline.hpp"

namespace {

using namespace blossom;

constexpr std::size_t segments = 10;

BSplineCurve spline(std::size_t degree, std::size_t bits) {
    std::mt19937_64 random(degree);
    std::vector<Rational> knots;
    for (std::size_t i = 0; i < segments + 2 * degree + 1; ++i) knots.emplace_back(i);
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < segments + degree; ++i)
        points.push_back({Rational(number(random, bits).numerator())});
    return {degree, knots, points};
}

/// Parameters in the domain, with denominators of `bits` bits, and their spans.
struct Places {
    std::vector<Rational> parameters;
    std::vector<std::size_t> spans;
};

Places places(const BSplineCurve& curve, std::size_t bits, std::size_t count) {
    std::mt19937_64 random(bits);
    Places result;
    while (result.parameters.size() < count) {
        const Rational place = number(random, bits);
        const Rational t(abs(place.numerator()) % (place.denominator() * segments), place.denominator());
        result.parameters.push_back(t + curve.knots().domain().a());
        result.spans.push_back(curve.knots().span_at(result.parameters.back()));
    }
    return result;
}

void compare_spline(const Report& report, std::size_t degree, std::size_t bits) {
    const BSplineCurve curve = spline(degree, bits);
    const SplineValues prepared(curve);
    const Places at = places(curve, bits, report.quick() ? 100 : 1000);
    std::vector<Rational> values;
    flint_peer::DeBoor flint(curve);
    const flint_peer::Arguments flint_parameters(at.parameters);
    const flint_peer::Arguments flint_values(at.parameters);
    const auto knots = boost_numbers<mpq_rational>(curve.knots().knots());
    const auto points = boost_numbers<mpq_rational>(flint_peer::DeBoor::first_coordinates(curve));
    const auto parameters = boost_numbers<mpq_rational>(at.parameters);
    std::vector<mpq_rational> boost_values(at.parameters.size());
    const auto joined = [](std::size_t count, const auto& text) {
        std::string result;
        for (std::size_t i = 0; i < count; ++i) result += text(i) + " ";
        return result;
    };
    const std::size_t count = at.parameters.size();
    report.compare(
        "splines", "de Boor", degree, bits,
        {{"engine", [&] { values = prepared.at(at.parameters); },
          [&] { return joined(count, [&](std::size_t i) { return to_string(values[i]); }); }},
         {"FLINT",
          [&] {
              for (std::size_t i = 0; i < count; ++i)
                  fmpq_set(flint_values.data() + i,
                           flint.value(static_cast<slong>(at.spans[i]), flint_parameters.data() + i));
          },
          [&] {
              return joined(count,
                            [&](std::size_t i) { return flint_peer::text_of(flint_values.data() + i); });
          }},
         {"mpq_rational",
          [&] {
              for (std::size_t i = 0; i < count; ++i)
                  boost_values[i] = textbook::de_boor(knots, points, degree, at.spans[i], parameters[i]);
          },
          [&] { return joined(count, [&](std::size_t i) { return boost_values[i].str(); }); }}});
}

/// A spline whose knots and points have numerators and denominators of `bits` bits.
BSplineCurve rational_spline(std::size_t degree, std::size_t bits) {
    std::mt19937_64 random(degree * 100 + bits);
    std::vector<Rational> knots;
    while (knots.size() < segments + 2 * degree + 1) {
        knots.push_back(number(random, bits));
        if (std::ranges::count(knots, knots.back()) > 1) knots.pop_back();
    }
    std::ranges::sort(knots);
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < segments + degree; ++i) points.push_back({number(random, bits)});
    return {degree, knots, points};
}

std::vector<Rational> inside(const BSplineCurve& curve, std::size_t bits, std::size_t count) {
    std::mt19937_64 random(bits + count);
    const Interval domain = curve.knots().domain();
    std::vector<Rational> result;
    while (result.size() < count) {
        const Rational t = number(random, bits);
        if (domain.a() <= t && t < domain.b()) result.push_back(t);
    }
    return result;
}

template <class Value>
void compare_values(const Report& report, const char* work, const BSplineCurve& curve, std::size_t bits,
                    const Value& value) {
    constexpr std::size_t count = 100;
    const std::vector<Rational> parameters = inside(curve, bits, count);
    std::vector<Rational> values;
    flint_peer::DeBoor flint(curve);
    const flint_peer::Arguments flint_parameters(parameters);
    const flint_peer::Arguments flint_values(parameters);
    std::vector<slong> spans;
    for (const Rational& t : parameters) spans.push_back(static_cast<slong>(curve.knots().span_at(t)));
    report.compare("splines", work, curve.degree(), bits,
                   {{"engine", [&] { values = value(parameters); },
                     [&] {
                         std::string text;
                         for (const Rational& number : values) text += to_string(number) + " ";
                         return text;
                     }},
                    {"FLINT",
                     [&] {
                         for (std::size_t i = 0; i < count; ++i)
                             fmpq_set(flint_values.data() + i,
                                      flint.value(spans[i], flint_parameters.data() + i));
                     },
                     [&] {
                         std::string text;
                         for (std::size_t i = 0; i < count; ++i)
                             text += flint_peer::text_of(flint_values.data() + i) + " ";
                         return text;
                     }}});
}

/// Inserts the knots one by one, or all at once.
void compare_insertion(const Report& report, const char* work, const BSplineCurve& curve, std::size_t bits,
                       std::size_t count, bool at_once) {
    std::vector<Rational> knots = inside(curve, bits, count);
    std::ranges::sort(knots);
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    std::erase_if(knots, [&](const Rational& knot) { return curve.knots().multiplicity(knot) > 0; });
    std::vector<std::vector<Rational>> lists;
    if (at_once) {
        lists.push_back(knots);
    } else {
        for (const Rational& knot : knots) lists.push_back({knot});
    }
    std::vector<BSplineCurve> refined;
    std::vector<std::unique_ptr<flint_peer::Refinement>> flint;
    for (const auto& list : lists) flint.push_back(std::make_unique<flint_peer::Refinement>(curve, list));
    report.compare("splines", work, curve.degree(), bits,
                   {{"engine",
                     [&] {
                         refined.clear();
                         for (const auto& list : lists) refined.push_back(insert_knots(curve, list));
                     },
                     [&] {
                         std::string text;
                         for (const BSplineCurve& one : refined) {
                             for (const Coordinates& point : one.control_points())
                                 text += to_string(point[0]) + " ";
                         }
                         return text;
                     }},
                    {"FLINT",
                     [&] {
                         for (const auto& one : flint) one->run();
                     },
                     [&] {
                         std::string text;
                         for (const auto& one : flint) text += one->text();
                         return text;
                     }}});
}

void compare_rational_knots(const Report& report, std::size_t degree, std::size_t bits) {
    const BSplineCurve curve = rational_spline(degree, bits);
    if (report.wants("values over rational knots", degree, bits)) {
        const SplineValues prepared(curve);
        compare_values(report, "values over rational knots", curve, bits,
                       [&](std::span<const Rational> parameters) { return prepared.at(parameters); });
    }
    if (report.wants("single values over rational knots", degree, bits)) {
        compare_values(report, "single values over rational knots", curve, bits,
                       [&](std::span<const Rational> parameters) {
                           std::vector<Rational> values;
                           for (const Rational& t : parameters) values.push_back(de_boor(curve, t).front());
                           return values;
                       });
    }
    if (report.wants("knot insertion", degree, bits))
        compare_insertion(report, "knot insertion", curve, bits, 30, false);
    if (report.wants("refinement by 1000 knots", degree, bits) && bits > 7)
        compare_insertion(report, "refinement by 1000 knots", curve, bits, 1000, true);
}

}  // namespace

void measure_splines(const Report& report) {
    for (const std::size_t bits : {7U, 20U, 64U}) {
        for (const std::size_t degree : {3U, 10U}) {
            if (report.wants("de Boor", degree, bits)) compare_spline(report, degree, bits);
            compare_rational_knots(report, degree, bits);
        }
    }
}
