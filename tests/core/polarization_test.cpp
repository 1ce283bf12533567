// The polarization inverse formula for anything that can be evaluated.

#include <blossom/core/blossom.hpp>

#include <set>

#include "support/failure.hpp"
#include "support/map_generators.hpp"
#include "support/map_printing.hpp"
#include "support/textbook_blossom.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Evaluates a polynomial by its powers, and remembers where.
struct Counted {
    std::vector<Coordinates> coefficients;
    std::vector<Rational> places = {};

    Coordinates operator()(const Rational& t) {
        places.push_back(t);
        Coordinates value(coefficients.front().size());
        Rational power = 1;
        for (const Coordinates& coefficient : coefficients) {
            for (std::size_t j = 0; j < value.size(); ++j) value[j] += coefficient[j] * power;
            power *= t;
        }
        return value;
    }
};

Coordinates from_values(Counted& counted, const std::vector<Parameter>& arguments,
                        const Limits& limits = {}) {
    return blossom_from_values(std::ref(counted), arguments, limits);
}

}  // namespace

TEST_CASE("the blossom of a callable is that of the polynomial", "[polarization]") {
    Random random(231);
    for (int i = 0; i < 600; ++i) {
        const std::size_t n = random.below(8);
        const PolynomialRecipe recipe = polynomial_map(random, n, random.one_in(3) ? Size::any : Size::small);
        Counted counted{recipe.coefficients};
        const std::vector<Parameter> list = points(random, n, Size::small);
        CHECK(textbook::text(from_values(counted, list)) ==
              textbook::blossom_of_coefficients(recipe.coefficients,
                                                std::vector<Argument>(list.begin(), list.end())));
    }
}

TEST_CASE("a callable is asked once for each sum of arguments", "[polarization]") {
    Random random(232);
    for (int i = 0; i < 300; ++i) {
        const std::size_t n = 1 + random.below(8);
        Counted counted{polynomial_map(random, n, Size::small).coefficients};
        const std::vector<Parameter> list = points(random, n, Size::small);
        from_values(counted, list);
        std::size_t terms = 1;
        std::vector<Parameter> seen;
        for (const Parameter& parameter : list) {
            if (std::ranges::find(seen, parameter) != seen.end()) continue;
            seen.push_back(parameter);
            terms *= static_cast<std::size_t>(std::ranges::count(list, parameter)) + 1;
        }
        CHECK(counted.places.size() == terms - 1);
    }
}

TEST_CASE("equal arguments are asked for at one place only", "[polarization]") {
    Counted counted{{{1}, {2}, {3}, {4}}};
    CHECK(from_values(counted, {Parameter(2), Parameter(2), Parameter(2)}) == Coordinates{49});
    CHECK(counted.places == std::vector<Rational>{2, 2, 2});
}

TEST_CASE("without arguments the callable is asked for its constant", "[polarization]") {
    Counted counted{{{Rational(3, 4), 7}}};
    CHECK(from_values(counted, {}) == Coordinates{Rational(3, 4), 7});
    CHECK(counted.places == std::vector<Rational>{0});
}

TEST_CASE("the means lie between the arguments", "[polarization]") {
    Counted counted{{{0}, {1}, {1}}};
    from_values(counted, {Parameter(Rational(1, 2)), Parameter(3)});
    const std::set<Rational> places(counted.places.begin(), counted.places.end());
    CHECK(places == std::set<Rational>{Rational(1, 2), Rational(7, 4), 3});
}

TEST_CASE("a callable is not asked at all beyond the limit", "[polarization][limits]") {
    Counted counted{{{1}, {1}}};
    std::vector<Parameter> list;
    for (int i = 0; i < 64; ++i) list.emplace_back(i);
    CHECK(failure_code([&] { from_values(counted, list); }) == ErrorCode::limit_exceeded);
    CHECK(counted.places.empty());
    Limits limits;
    limits.polarization_terms = 4;
    CHECK(from_values(counted, {Parameter(1), Parameter(2)}, limits) == Coordinates{Rational(5, 2)});
    counted.places.clear();
    limits.polarization_terms = 3;
    CHECK(failure_code([&] { from_values(counted, {Parameter(1), Parameter(2)}, limits); }) ==
          ErrorCode::limit_exceeded);
    CHECK(counted.places.empty());
}
