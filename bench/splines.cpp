// A B-spline curve of ten segments with knots 0, 1, ... at a thousand parameters.

#include <blossom/core/spline/curve_values.hpp>

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

}  // namespace

void measure_splines(const Report& report) {
    for (const std::size_t bits : {7U, 20U, 64U}) {
        for (const std::size_t degree : {3U, 10U}) {
            if (report.wants("de Boor", degree, bits)) compare_spline(report, degree, bits);
        }
    }
}
