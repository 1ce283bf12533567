// A polynomial at a thousand parameters.

#include <blossom/core/spline/curve_values.hpp>

#include "cases.hpp"
#include "families.hpp"
#include "flint_operations.hpp"

namespace {

using namespace blossom;

void compare_evaluation(const Report& report, std::size_t degree, std::size_t bits) {
    const PolynomialCurve curve = curve_of(make_case(degree, bits));
    std::mt19937_64 random(bits);
    std::vector<Rational> parameters;
    for (std::size_t i = 0; i < (report.quick() ? 100 : 1000); ++i)
        parameters.push_back(number(random, bits));
    const CurveValues prepared(curve);
    std::vector<Rational> values;
    flint_peer::Values flint(curve.coefficients().numbers(), parameters);
    report.compare("operations", "evaluation", degree, bits,
                   {{"engine", [&] { values = prepared.at(parameters); },
                     [&] {
                         std::string text;
                         for (const Rational& value : values) text += to_string(value) + " ";
                         return text;
                     }},
                    {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

}  // namespace

void measure_evaluation(const Report& report) {
    for (const std::size_t bits : {7U, 64U}) {
        for (const std::size_t degree : {3U, 10U, 100U}) {
            if (report.wants("evaluation", degree, bits)) compare_evaluation(report, degree, bits);
        }
    }
}
