// One blossom value by each construction, against the textbook loop of that construction on Boost's
// mpq_rational. Rows are <construction>/<engine or textbook>/<degree>/<bits of numerators and denominators>.
// Every pair of rows is checked to give the same number before anything is timed; run with random
// interleaving, see scripts/bench.

#include <benchmark/benchmark.h>

#include <blossom/core/blossom.hpp>
#include <blossom/core/conversion.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "textbook.hpp"

namespace {

using namespace blossom;

/// A polynomial of formal degree n and n distinct-looking arguments, the same for both sides.
struct Case {
    PolynomialCurve curve;
    BezierCurve polygon;
    std::vector<Argument> arguments;
    textbook::Numbers coefficients;
    textbook::Numbers control_points;
    textbook::Numbers numbers;
};

textbook::Number boost_number(const Rational& value) { return textbook::Number(to_string(value)); }

Case make_case(std::size_t n, int bits) {
    std::mt19937_64 random(n * 1000 + static_cast<std::size_t>(bits));
    const auto number = [&] {
        const auto numerator = static_cast<std::int64_t>(random()) >> (64 - bits);
        const auto denominator = static_cast<std::int64_t>(random() >> 1 >> (64 - bits)) | 1;
        return Rational(numerator, denominator);
    };
    std::vector<Coordinates> coefficients;
    for (std::size_t k = 0; k <= n; ++k) coefficients.push_back({number()});
    const PolynomialCurve curve(coefficients);
    Case result{curve, control_points(curve, Interval()), {}, {}, {}, {}};
    for (std::size_t k = 0; k < n; ++k) {
        const Rational argument = number();
        result.arguments.push_back(Parameter(argument));
        result.numbers.push_back(boost_number(argument));
    }
    for (const auto& point : coefficients) result.coefficients.push_back(boost_number(point[0]));
    for (const auto& point : result.polygon.control_points().to_points()) {
        result.control_points.push_back(boost_number(point[0]));
    }
    return result;
}

void add_pair(const std::string& construction, std::size_t degree, int bits, std::function<Rational()> engine,
              std::function<textbook::Number()> loop) {
    const std::string size = "/" + std::to_string(degree) + "/" + std::to_string(bits);
    if (boost_number(engine()) != loop()) {
        std::fprintf(stderr, "%s%s: engine and textbook loop disagree\n", construction.c_str(), size.c_str());
        std::exit(1);
    }
    const auto row = [&](const char* side, auto function) {
        benchmark::RegisterBenchmark((construction + "/" + side + size).c_str(),
                                     [=](benchmark::State& state) {
                                         for (auto _ : state) benchmark::DoNotOptimize(function());
                                     });
    };
    row("engine", std::move(engine));
    row("textbook", std::move(loop));
}

void add_rows(std::size_t degree, int bits) {
    const auto given = std::make_shared<Case>(make_case(degree, bits));
    const auto by = [given](const PolynomialMap& map, Construction construction) {
        return [given, map, construction] { return blossom_value(map, given->arguments, construction)[0]; };
    };
    const auto prepared = std::make_shared<Blossom>(given->curve);
    add_pair(
        "prepared", degree, bits, [=] { return (*prepared)(given->arguments)[0]; },
        [=] { return textbook::symmetric(given->coefficients, given->numbers); });
    add_pair("symmetric", degree, bits, by(given->curve, Construction::symmetric),
             [=] { return textbook::symmetric(given->coefficients, given->numbers); });
    add_pair("casteljau", degree, bits, by(given->polygon, Construction::casteljau),
             [=] { return textbook::casteljau(given->control_points, given->numbers); });
    if (degree <= 10) {
        add_pair("polarization", degree, bits, by(given->curve, Construction::polarization),
                 [=] { return textbook::polarization(given->coefficients, given->numbers); });
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    for (const int bits : {4, 7, 64}) {
        for (const std::size_t degree : {3, 10, 20, 100}) add_rows(degree, bits);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
