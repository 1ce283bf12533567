// One blossom value: the engine beside FLINT in expert hands and beside textbook loops on Boost's rational
// numbers, interleaved in one process. Every side is checked to give the same number before it is timed.
//
//   bench_values [--quick]        rows of CSV, see `header`
//   bench_values --case N BITS    coefficients, arguments and the value, for peers that are processes
//   bench_values --kernels        which kernel is chosen when

#include <blossom/core/blossom.hpp>
#include <blossom/rational/linear_factor_sums.hpp>

#include <sys/resource.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "cases.hpp"
#include "flint_peer.hpp"
#include "measure.hpp"
#include "textbook.hpp"

namespace {

using namespace blossom;
using boost::multiprecision::cpp_rational;
using boost::multiprecision::mpq_rational;

constexpr const char* header =
    "work,degree,bits,engine_ns,peer,peer_ns,ratio,least_ratio,greatest_ratio,peak_memory_kib";

template <class Number>
textbook::Numbers<Number> boost_numbers(std::span<const Rational> values) {
    textbook::Numbers<Number> result;
    for (const Rational& value : values) result.push_back(Number(to_string(value)));
    return result;
}

void require_equal(const Case& given, const char* peer, const std::string& expected,
                   const std::string& value) {
    if (expected == value) return;
    std::fprintf(stderr, "degree %zu, %zu bits: %s gives another value\n", given.degree, given.bits, peer);
    std::exit(1);
}

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

struct Side {
    std::string name;
    std::function<void()> run;
    std::function<std::string()> text;  ///< of the value that `run` found
};

/// Checks and times `sides`, the engine first.
void print_rows(const char* work, const Case& given, const std::vector<Side>& sides,
                const measure::Effort& effort) {
    std::vector<std::function<void()>> runs;
    sides[0].run();
    for (const Side& side : sides) {
        side.run();
        require_equal(given, side.name.c_str(), sides[0].text(), side.text());
        runs.push_back(side.run);
    }
    const measure::Comparison comparison = measure::compare(runs, effort);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const measure::Ratio& ratio = comparison.ratios[i - 1];
        std::printf("%s,%zu,%zu,%.1f,%s,%.1f,%.2f,%.2f,%.2f,%ld\n", work, given.degree, given.bits,
                    1e9 * comparison.seconds[0], sides[i].name.c_str(), 1e9 * comparison.seconds[i],
                    ratio.median, ratio.least, ratio.greatest, peak_memory());
    }
    std::fflush(stdout);
}

/// The textbook takes seconds beyond.
bool textbook_is_bearable(const Case& given) {
    return given.degree <= 20 || (given.degree <= 100 && given.bits <= 64);
}

template <class Number>
Side textbook_side(const char* name, const Case& given) {
    auto coefficients = boost_numbers<Number>(given.coefficients);
    auto arguments = boost_numbers<Number>(given.arguments);
    auto value = std::make_shared<Number>();
    return {name, [=] { *value = textbook::symmetric(coefficients, arguments); },
            [=] { return value->str(); }};
}

/// The constructions by name, each beside its own textbook loop.
void compare_constructions(const Case& given, const PolynomialCurve& curve,
                           std::span<const Argument> arguments, const measure::Effort& effort) {
    Rational value;
    const auto text = [&] { return to_string(value); };
    const BezierCurve polygon = control_points(curve, Interval());
    std::vector<Rational> points;
    for (const auto& point : polygon.control_points().to_points()) points.push_back(point[0]);
    const auto boost_points = boost_numbers<mpq_rational>(points);
    const auto boost_arguments = boost_numbers<mpq_rational>(given.arguments);
    mpq_rational boost_value;
    print_rows(
        "casteljau", given,
        {{"engine", [&] { value = blossom_value(polygon, arguments, Construction::casteljau)[0]; }, text},
         {"mpq_rational", [&] { boost_value = textbook::casteljau(boost_points, boost_arguments); },
          [&] { return boost_value.str(); }}},
        effort);
    // 2^n values of the polynomial
    if (given.degree > 10) return;
    const auto boost_coefficients = boost_numbers<mpq_rational>(given.coefficients);
    print_rows(
        "polarization", given,
        {{"engine", [&] { value = blossom_value(curve, arguments, Construction::polarization)[0]; }, text},
         {"mpq_rational", [&] { boost_value = textbook::polarization(boost_coefficients, boost_arguments); },
          [&] { return boost_value.str(); }}},
        effort);
}

void compare_values(std::size_t degree, std::size_t bits, const measure::Effort& effort) {
    const Case given = make_case(degree, bits);
    const PolynomialCurve curve = curve_of(given);
    std::vector<Argument> arguments;
    for (const Rational& value : given.arguments) arguments.emplace_back(Parameter(value));

    const Blossom blossom(curve);
    Rational value;
    const auto text = [&] { return to_string(value); };
    flint_peer::Polynomial flint(curve.coefficients().numbers());
    const flint_peer::Arguments flint_arguments(given.arguments);
    flint.prepare();
    const auto flint_text = [&] { return flint.text(); };

    std::vector<Side> prepared{
        {"engine", [&] { value = blossom.coordinate(0, arguments); }, text},
        {"FLINT", [&] { flint.value(flint_arguments); }, flint_text},
    };
    if (textbook_is_bearable(given)) {
        prepared.push_back(textbook_side<mpq_rational>("mpq_rational", given));
        if (degree <= 20) prepared.push_back(textbook_side<cpp_rational>("cpp_rational", given));
    }
    print_rows("prepared", given, prepared, effort);

    std::vector<Side> once{
        {"engine", [&] { value = blossom_value(curve, arguments, Construction::symmetric)[0]; }, text},
        {"FLINT",
         [&] {
             flint.prepare();
             flint.value(flint_arguments);
         },
         flint_text},
    };
    if (textbook_is_bearable(given)) once.push_back(textbook_side<mpq_rational>("mpq_rational", given));
    print_rows("one-shot", given, once, effort);

    if (degree <= 20) {
        std::vector<std::vector<Argument>> tuples(8, arguments);
        print_rows("batch of 8", given,
                   {{"engine", [&] { value = blossom.values(tuples).back(); }, text},
                    {"FLINT",
                     [&] {
                         for (int i = 0; i < 8; ++i) flint.value(flint_arguments);
                     },
                     flint_text}},
                   effort);
    }
    if (textbook_is_bearable(given)) compare_constructions(given, curve, arguments, effort);
}

void print_case(const Case& given) {
    std::vector<Argument> arguments;
    for (const Rational& value : given.arguments) arguments.emplace_back(Parameter(value));
    for (const Rational& coefficient : given.coefficients) std::printf("%s ", to_string(coefficient).c_str());
    std::printf("\n");
    for (const Rational& argument : given.arguments) std::printf("%s ", to_string(argument).c_str());
    std::printf("\n%s\n", to_string(Blossom(curve_of(given)).coordinate(0, arguments)).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode == "--kernels") {
        for (const SumKernelRule& rule : sum_kernel_rules())
            std::printf("%-10s %s\n", std::string(rule.name).c_str(), std::string(rule.condition).c_str());
        return 0;
    }
    if (mode == "--case" && argc == 4) {
        print_case(make_case(std::strtoul(argv[2], nullptr, 10), std::strtoul(argv[3], nullptr, 10)));
        return 0;
    }
    const bool quick = mode == "--quick";
    const measure::Effort effort = quick ? measure::Effort{1, 1e-5} : measure::Effort{};
    std::printf("%s\n", header);
    for (const std::size_t bits : {4U, 7U, 64U, 256U}) {
        for (const std::size_t degree : {3U, 10U, 20U, 40U, 100U, 300U, 1000U, 3000U}) {
            if (degree * bits <= (quick ? 20'000U : 64'000U)) compare_values(degree, bits, effort);
        }
    }
    return 0;
}
