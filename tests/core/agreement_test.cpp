#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/agreement.hpp>
#include "core_test.hpp"

#include "support/symbolic.hpp"

namespace {

const PolynomialMap cubic = PolynomialCurve(parse_univariate("1 + 2t + 4t^2 - t^3").polynomial);

Agreement<int> results(std::initializer_list<std::optional<int>> values) {
    Agreement<int> agreement;
    for (const auto& value : values)
        agreement.results.push_back({Construction::symmetric, value, value ? "" : "skipped"});
    return agreement;
}

}  // namespace

TEST_CASE("agreement needs two values that are equal, and no other", "[agreement]") {
    CHECK(results({1, 1, 1}).agree());
    CHECK_FALSE(results({1, 1, 2}).agree());
    CHECK_FALSE(results({1, 2, 1}).agree());
    CHECK_FALSE(results({2, 1, 1}).agree());
    CHECK(results({1, {}, 1}).agree());
    CHECK_FALSE(results({1, {}, 2}).agree());
    CHECK_FALSE(results({{}, {}, 1}).agree());
    CHECK_FALSE(results({1}).agree());
    CHECK_FALSE(results({}).agree());
    CHECK_FALSE(results({{}, {}, {}}).agree());
}

TEST_CASE("the cubic of the first example agrees at 1, 2, 3", "[agreement]") {
    const std::vector<Argument> arguments{Parameter(1), Parameter(2), Parameter(3)};
    const auto three = agreement(cubic, arguments);
    REQUIRE(three.results.size() == 3);
    CHECK(three.results[0].construction == Construction::symmetric);
    CHECK(three.results[1].construction == Construction::polarization);
    CHECK(three.results[2].construction == Construction::casteljau);
    for (const auto& result : three.results) {
        REQUIRE(result.value);
        CHECK(*result.value == Coordinates{Rational(41, 3)});
        CHECK(result.skipped.empty());
    }
    CHECK(three.agree());
}

TEST_CASE("the three constructions agree on maps of both kinds", "[agreement]") {
    Random random(221);
    for (int i = 0; i < 600; ++i) {
        const std::size_t n = random.below(8);
        const PolynomialMap map = any_map(random, n, Size::any);
        const auto three = agreement(map, arguments(random, n, Size::any));
        CHECK(three.agree());
        for (const auto& result : three.results) CHECK(result.value);
    }
}

TEST_CASE("polarization beyond its limit is skipped with the reason and not counted", "[agreement]") {
    Limits limits;
    limits.polarization_terms = 8;
    const std::vector<Argument> distinct{Parameter(1), Parameter(2), Parameter(3)};
    CHECK(agreement(cubic, distinct, limits).results[1].value);
    limits.polarization_terms = 7;
    const auto skipping = agreement(cubic, distinct, limits);
    CHECK_FALSE(skipping.results[1].value);
    CHECK(skipping.results[1].skipped.find("polarization_terms = 7") != std::string::npos);
    CHECK(skipping.agree());
    // Repeated arguments are grouped: prod(m_i + 1) terms.
    limits.polarization_terms = 4;
    const std::vector<Argument> equal{Parameter(1), Parameter(1), Parameter(1)};
    CHECK(agreement(cubic, equal, limits).results[1].value);
    limits.polarization_terms = 3;
    CHECK_FALSE(agreement(cubic, equal, limits).results[1].value);
}

TEST_CASE("degree 64 by polarization is refused by itself and skipped in agreement", "[agreement][limits]") {
    const PolynomialMap map = PolynomialCurve(Polynomial::monomial(64));
    std::vector<Argument> list;
    for (int i = 1; i <= 64; ++i) list.emplace_back(Parameter(i));
    const auto error = failure([&] { blossom_value(map, list, Construction::polarization); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::limit_exceeded);
    CHECK(error->message().find("polarization_terms") != std::string::npos);
    const auto three_others = agreement(map, list);
    REQUIRE(three_others.results.size() == 4);
    CHECK_FALSE(three_others.results[1].value);
    CHECK(three_others.results[2].construction == Construction::regrouped_polarization);
    CHECK(three_others.results[2].value);
    CHECK(three_others.agree());
    Limits limits;
    limits.regrouping_work = 1000;
    const auto two = agreement(map, list, limits);
    CHECK_FALSE(two.results[2].value);
    CHECK(two.results[2].skipped.find("regrouping_work = 1000") != std::string::npos);
    CHECK(two.agree());
    // 32 + 32 copies are 33 * 33 terms.
    const std::vector<Argument> grouped = with_copies(with_copies({}, 32, Parameter(2)), 32, Parameter(3));
    const auto three = agreement(map, grouped);
    CHECK(three.results[1].value);
    CHECK(three.agree());
}

TEST_CASE("agreement for all arguments expands the blossom", "[agreement]") {
    const auto proof = agreement_for_all_arguments(cubic);
    CHECK(proof.agree());
    REQUIRE(proof.results.size() == 3);
    const auto expected =
        parse_polynomial("1 + 2/3(u1+u2+u3) + 4/3(u1*u2+u1*u3+u2*u3) - u1*u2*u3", numbered_names("u", 3))
            .polynomial;
    for (const auto& result : proof.results) {
        REQUIRE(result.value);
        CHECK(*result.value == std::vector<SparsePolynomial>{expected});
    }
    const auto forms = elementary_symmetric_form(cubic);
    REQUIRE(forms.size() == 1);
    CHECK(to_text(forms[0], numbered_names("e", 3)) == "1 + 2/3 e1 + 4/3 e2 - e3");
}

TEST_CASE("agreement for all arguments on maps of both kinds, and at samples of them", "[agreement]") {
    Random random(222);
    for (int i = 0; i < 50; ++i) {
        const std::size_t n = random.below(6);
        const bool bezier = random.one_in(2);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::any);
        const BezierRecipe polygon = bezier_map(random, n, Size::any);
        const PolynomialMap map = bezier ? PolynomialMap(polygon.curve()) : PolynomialMap(recipe.curve());
        const auto proof = agreement_for_all_arguments(map);
        CHECK(proof.agree());
        REQUIRE(proof.results[1].value);

        const std::vector<Parameter> parameters = points(random, n, Size::small);
        const std::vector<Argument> list(parameters.begin(), parameters.end());
        std::vector<Rational> values;
        for (const Parameter& parameter : parameters) values.push_back(parameter.value);
        Coordinates at_sample;
        for (const SparsePolynomial& coordinate : *proof.results[0].value)
            at_sample.push_back(coordinate(values));
        const auto expected =
            bezier ? textbook::blossom_of_control_points(polygon.control_points, polygon.interval, list)
                   : textbook::blossom_of_coefficients(recipe.coefficients, list);
        CHECK(textbook::text(at_sample) == expected);
    }
}

TEST_CASE("the elementary symmetric form is the blossom with its functions put in", "[agreement]") {
    Random random(223);
    for (int i = 0; i < 60; ++i) {
        const std::size_t n = random.below(6);
        const PolynomialMap map = any_map(random, n, Size::any);
        const auto forms = elementary_symmetric_form(map);
        const auto expanded = *agreement_for_all_arguments(map).results[0].value;
        REQUIRE(forms.size() == expanded.size());
        const Symbols symbols = Variables().next(n);
        for (std::size_t j = 0; j < forms.size(); ++j) {
            Symbols terms;
            for (std::size_t term = 0; term < forms[j].size(); ++term) {
                Symbol product = SparsePolynomial(forms[j].coefficient(term));
                for (std::size_t k = 1; k <= n; ++k) {
                    const Symbol function = subset_average(symbols, k) * Symbol(binomial(n, k));
                    product *= pow(function, forms[j].exponent(term, k - 1));
                }
                terms.push_back(product);
            }
            CHECK(sum(terms) == expanded[j]);
        }
    }
}

TEST_CASE("agreement for all arguments keeps to its limits", "[agreement][limits]") {
    const auto error =
        failure([] { agreement_for_all_arguments(PolynomialCurve(Polynomial::monomial(64))); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::limit_exceeded);
    CHECK(error->message().find("expansion_terms") != std::string::npos);
    CHECK(failure_code([] { agreement_for_all_arguments(PolynomialCurve(Polynomial(1), 10'000)); }) ==
          ErrorCode::limit_exceeded);
    Limits limits;
    limits.expansion_work = 10;
    const auto two = agreement_for_all_arguments(cubic, limits);
    CHECK_FALSE(two.results[1].value);
    CHECK(two.results[1].skipped.find("expansion_work = 10") != std::string::npos);
    CHECK(two.agree());
}

TEST_CASE("disagreement would be seen", "[agreement]") {
    auto proof = agreement_for_all_arguments(cubic);
    (*proof.results[2].value)[0] += SparsePolynomial::variable(0);
    CHECK_FALSE(proof.agree());
    auto values = agreement(cubic, std::vector<Argument>{Parameter(1), Parameter(2), Parameter(3)});
    values.results[1].value->front() += Rational(1, Integer(1) << 500);
    CHECK_FALSE(values.agree());
}
