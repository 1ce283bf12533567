// Each construction by name, compared with its own textbook loop.

#include <blossom/core/blossom/blossom.hpp>

#include "boost_numbers.hpp"
#include "cases.hpp"
#include "families.hpp"
#include "gray_code.hpp"

namespace {

using namespace blossom;

/// The value by `construction` for `map`, compared with a loop on Boost's numbers.
template <class Loop>
void compare_construction(const Report& report, const Case& given, const PolynomialMap& map,
                          Construction construction, const Loop& loop) {
    const std::vector<Argument> arguments = arguments_of(given);
    Rational value;
    mpq_rational boost_value;
    report.compare("constructions", std::string(construction_name(construction)).c_str(), given.degree,
                   given.bits,
                   {{"engine", [&] { value = blossom_value(map, arguments, construction)[0]; },
                     [&] { return to_string(value); }},
                    {"mpq_rational", [&] { boost_value = loop(); }, [&] { return boost_value.str(); }}});
}

void compare_casteljau(const Report& report, const Case& given) {
    const BezierCurve polygon = control_points(curve_of(given), Interval());
    std::vector<Rational> points;
    for (const auto& point : polygon.control_points().to_points()) points.push_back(point[0]);
    const auto boost_points = boost_numbers<mpq_rational>(points);
    const auto boost_arguments = boost_numbers<mpq_rational>(given.arguments);
    compare_construction(report, given, polygon, Construction::casteljau,
                         [&] { return textbook::casteljau(boost_points, boost_arguments); });
}

void compare_polarization(const Report& report, const Case& given) {
    const auto boost_coefficients = boost_numbers<mpq_rational>(given.coefficients);
    const auto boost_arguments = boost_numbers<mpq_rational>(given.arguments);
    compare_construction(report, given, curve_of(given), Construction::polarization,
                         [&] { return textbook::polarization(boost_coefficients, boost_arguments); });
}

/// Every subset, compared with the loop in the order of the Gray code.
void compare_gray_code(const Report& report, const Case& given) {
    const PolynomialCurve curve = curve_of(given);
    const std::vector<Argument> arguments = arguments_of(given);
    Rational value;
    GrayCodePolarization gray_code(curve.coefficients().numbers(), RationalVector(given.arguments));
    report.compare(
        "constructions", "polarization", given.degree, given.bits,
        {{"engine", [&] { value = blossom_value(curve, arguments, Construction::polarization)[0]; },
          [&] { return to_string(value); }},
         {"GMP Gray code", [&] { gray_code.run(); }, [&] { return gray_code.text(); }}});
}

/// Only the polarization of this name; its value is checked against the one by symmetric functions.
void show_polarization(const Report& report, std::size_t degree, std::size_t bits,
                       Construction construction) {
    const std::string name(construction_name(construction));
    if (!report.wants(name, degree, bits)) return;
    const Case given = make_case(degree, bits);
    const PolynomialCurve curve = curve_of(given);
    const std::vector<Argument> arguments = arguments_of(given);
    Limits limits;
    limits.polarization_terms = std::size_t{1} << degree;
    Rational value;
    const auto side = [&](const char* side_name, Construction by) {
        return Side{side_name, [&, by] { value = blossom_value(curve, arguments, by, limits)[0]; },
                    [&] { return to_string(value); }};
    };
    report.compare("constructions", name.c_str(), degree, bits,
                   {side("engine", construction), side("symmetric functions", Construction::symmetric)});
}

}  // namespace

void measure_constructions(const Report& report) {
    for (const std::size_t bits : {4U, 7U, 64U, 256U}) {
        for (const std::size_t degree : {3U, 10U, 20U, 40U, 100U}) {
            const Case given = make_case(degree, bits);
            if (!textbook_is_bearable(given)) continue;
            if (report.wants("casteljau", degree, bits)) compare_casteljau(report, given);
            // 2^n values of the polynomial
            if (degree <= 10 && report.wants("polarization", degree, bits))
                compare_polarization(report, given);
        }
    }
    const std::pair<std::size_t, std::size_t> subsets[] = {{10, 4}, {15, 4}, {20, 4}, {15, 64}};
    for (const auto& [degree, bits] : subsets) {
        if (degree > 10 && report.quick()) continue;
        if (report.wants("polarization", degree, bits)) compare_gray_code(report, make_case(degree, bits));
    }
    const std::pair<std::size_t, std::size_t> regrouped[] = {{10, 4}, {20, 64}, {100, 4}, {100, 7}};
    for (const auto& [degree, bits] : regrouped)
        if (degree <= 20 || !report.quick())
            show_polarization(report, degree, bits, Construction::regrouped_polarization);
    if (!report.quick()) show_polarization(report, 25, 4, Construction::polarization);
}
