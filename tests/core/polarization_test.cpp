#include <blossom/core/constructions/constructions.hpp>
#include "core_test.hpp"

// The polarization inverse formula for any map that can be evaluated.

namespace {

/// Evaluates a polynomial by its powers, and records the parameters.
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

TEST_CASE("a callable is evaluated once for each sum of arguments", "[polarization]") {
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

TEST_CASE("without arguments the callable gives its constant", "[polarization]") {
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

TEST_CASE("a callable is not evaluated beyond the limit", "[polarization][limits]") {
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

namespace {

/// Points, vectors and pairs of any mass, some of them repeated.
std::vector<Argument> mixed_arguments(Random& random, std::size_t n) {
    std::vector<Argument> list;
    while (list.size() < n) {
        Argument argument = Parameter(small_rational(random));
        if (random.one_in(6)) argument = Argument(Direction{small_rational(random)});
        if (random.one_in(6)) argument = Argument(small_rational(random), small_rational(random));
        list.push_back(argument);
        if (random.one_in(4)) list.resize(std::min(n, list.size() + 1 + random.below(3)), argument);
    }
    return list;
}

}  // namespace

TEST_CASE("both polarizations give the blossom at points, vectors and pairs of any mass",
          "[polarization][fj-cor1]") {
    Random random(233);
    for (int i = 0; i < 300; ++i) {
        const std::size_t n = random.below(i % 10 == 0 ? 13 : 9);
        const PolynomialMap map = random.one_in(2)
                                      ? PolynomialMap(polynomial_map(random, n, Size::any).curve())
                                      : PolynomialMap(bezier_map(random, n, Size::small).curve());
        const std::vector<Argument> list = mixed_arguments(random, n);
        const Coordinates expected = blossom_value(map, list, Construction::symmetric);
        CHECK(blossom_value(map, list, Construction::polarization) == expected);
        CHECK(blossom_value(map, list, Construction::regrouped_polarization) == expected);
    }
}

TEST_CASE("regrouped polarization of higher degrees", "[polarization]") {
    Random random(234);
    for (const std::size_t n : {20U, 33U, 48U}) {
        const PolynomialMap map = polynomial_map(random, n, Size::small).curve();
        const std::vector<Argument> list = mixed_arguments(random, n);
        CHECK(blossom_value(map, list, Construction::regrouped_polarization) ==
              blossom_value(map, list, Construction::symmetric));
    }
}

TEST_CASE("polarizations where primes of the residues divide the denominators", "[polarization]") {
    Random random(236);
    for (const std::int64_t prime : {(std::int64_t{1} << 50) - 16383, (std::int64_t{1} << 28) - 65535}) {
        for (std::size_t n = 1; n < 9; ++n) {
            const PolynomialMap map = polynomial_map(random, n, Size::small).curve();
            std::vector<Argument> list = mixed_arguments(random, n);
            list.front() = Parameter(Rational(5, prime));
            const Coordinates expected = blossom_value(map, list, Construction::symmetric);
            CHECK(blossom_value(map, list, Construction::polarization) == expected);
            CHECK(blossom_value(map, list, Construction::regrouped_polarization) == expected);
        }
    }
}

TEST_CASE("polarization of more bits than residues take", "[polarization]") {
    const PolynomialMap map = PolynomialCurve(Polynomial::monomial(6));
    std::vector<Argument> list(5, Parameter(1));
    list[1] = Parameter(2);
    list[2] = Parameter(3);
    list[3] = Parameter(4);
    const Integer large = Integer(1) << 1'000'100;
    list.emplace_back(Parameter(large));
    CHECK(blossom_value(map, list, Construction::polarization) == Coordinates{Integer(24) * large});
    CHECK(blossom_value(map, list, Construction::regrouped_polarization) == Coordinates{Integer(24) * large});
}

TEST_CASE("power sums over subsets as defined", "[polarization]") {
    Random random(235);
    for (int i = 0; i < 100; ++i) {
        const std::size_t n = random.below(6);
        std::vector<HomogeneousPair<Integer>> pairs;
        for (std::size_t j = 0; j < n; ++j)
            pairs.push_back({integer(random, IntegerKind::tiny), random.one_in(3) ? 0 : 7});
        const auto sums = constructions::signed_power_sums<Integer>(pairs);
        std::vector<std::vector<Integer>> expected(sums.size(), std::vector<Integer>(n + 1));
        for (std::size_t subset = 0; subset < std::size_t{1} << n; ++subset) {
            HomogeneousPair<Integer> sum{0, 0};
            int sign = 1;
            for (std::size_t j = 0; j < n; ++j) {
                if ((subset >> j & 1) == 0) {
                    sign = -sign;
                } else {
                    sum.u += pairs[j].u;
                    sum.mass += pairs[j].mass;
                }
            }
            const auto points = static_cast<std::size_t>(*(sum.mass / 7).to_int64());
            for (std::size_t k = 0; k <= n; ++k) expected[points][k] += Integer(sign) * pow(sum.u, k);
        }
        CHECK(sums == expected);
    }
}

TEST_CASE("regrouped polarization is refused beyond its limit", "[polarization][limits]") {
    const PolynomialMap map = PolynomialCurve(Polynomial::monomial(4));
    const std::vector<Argument> list(4, Parameter(2));
    Limits limits;
    limits.regrouping_work = 100;
    CHECK(blossom_value(map, list, Construction::regrouped_polarization, limits) == Coordinates{16});
    limits.regrouping_work = 99;
    const auto error =
        failure([&] { blossom_value(map, list, Construction::regrouped_polarization, limits); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::limit_exceeded);
    CHECK(error->message().find("regrouping_work") != std::string::npos);
    CHECK(error->place() == Part::arguments);
}
