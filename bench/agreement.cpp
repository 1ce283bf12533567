// The three constructions on symbols, compared with each other: what `agree` proves for all arguments.

#include <blossom/core/blossom/agreement.hpp>

#include "cases.hpp"
#include "families.hpp"
#include "flint_agreement.hpp"

namespace {

using namespace blossom;

void compare_agreement(const Report& report, std::size_t degree, std::size_t bits) {
    std::vector<Integer> coefficients;
    for (const Rational& coefficient : make_case(degree, bits).coefficients)
        coefficients.push_back(coefficient.numerator());
    const PolynomialMap map = PolynomialCurve(PointArray(1, RationalVector(coefficients, 1)));
    Agreement<std::vector<SparsePolynomial>> agreement;
    flint_peer::SymbolicBlossoms by_horner(coefficients, false);
    flint_peer::SymbolicBlossoms by_powers(coefficients, true);
    report.compare("agreement", "agree for all arguments", degree, bits,
                   {{"engine", [&] { agreement = agreement_for_all_arguments(map); },
                     [&] {
                         const std::size_t terms = agreement.results.front().value->front().size();
                         return std::to_string(static_cast<int>(agreement.agree())) + " " +
                                std::to_string(terms);
                     }},
                    {"FLINT", [&] { by_horner.run(); }, [&] { return by_horner.text(); }},
                    {"FLINT by powers", [&] { by_powers.run(); }, [&] { return by_powers.text(); }}});
}

}  // namespace

void measure_agreement(const Report& report) {
    for (const std::size_t degree : {3U, 6U, 8U, 10U}) {
        if (report.quick() && degree > 8) continue;
        if (report.wants("agree for all arguments", degree, 7)) compare_agreement(report, degree, 7);
    }
}
