#include "core_test.hpp"

// Every construction compared with the definition, summed over all subsets, on numbers of another library.

TEST_CASE("every construction on polynomial maps against the definition", "[blossom][oracle]") {
    Random random(211);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t n = random.below(8);
        const Size size = random.one_in(3) ? Size::any : Size::small;
        const PolynomialRecipe recipe = polynomial_map(random, n, size);
        const std::vector<Argument> list = arguments(random, n, random.one_in(3) ? Size::any : Size::small);
        const auto expected = textbook::blossom_of_coefficients(recipe.coefficients, list);
        for (const auto& [name, construct] : every_construction()) {
            CAPTURE(name, n, list);
            CHECK(textbook::text(construct(recipe.curve(), list)) == expected);
        }
    }
}

TEST_CASE("every construction on control polygons against the definition", "[blossom][oracle]") {
    Random random(212);
    for (int i = 0; i < 1000; ++i) {
        const std::size_t n = random.below(8);
        const Size size = random.one_in(3) ? Size::any : Size::small;
        const BezierRecipe recipe = bezier_map(random, n, size);
        const std::vector<Argument> list = arguments(random, n, random.one_in(3) ? Size::any : Size::small);
        const auto expected =
            textbook::blossom_of_control_points(recipe.control_points, recipe.interval, list);
        for (const auto& [name, construct] : every_construction()) {
            CAPTURE(name, n, list, recipe.interval.a(), recipe.interval.b());
            CHECK(textbook::text(construct(recipe.curve(), list)) == expected);
        }
    }
}

TEST_CASE("high degrees and few different arguments", "[blossom][oracle]") {
    Random random(213);
    for (const std::size_t n : {12U, 13U}) {
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::small);
        const BezierRecipe bezier = bezier_map(random, n, Size::small);
        std::vector<Argument> list = with_copies({}, n / 2, point(random, Size::any));
        list = with_copies(list, n - list.size() - 1, argument(random, Size::small));
        list.emplace_back(delta);
        for (const auto& [name, construct] : every_construction()) {
            CAPTURE(name, n);
            CHECK(textbook::text(construct(recipe.curve(), list)) ==
                  textbook::blossom_of_coefficients(recipe.coefficients, list));
            CHECK(textbook::text(construct(bezier.curve(), list)) ==
                  textbook::blossom_of_control_points(bezier.control_points, bezier.interval, list));
        }
    }
}

TEST_CASE("the blossom of degree 0 is the constant", "[blossom]") {
    const std::vector<Coordinates> constant{{Rational(5, 7), -3}};
    for (const PolynomialMap& map :
         {PolynomialMap(PolynomialCurve(constant)), PolynomialMap(BezierCurve(constant, Interval(2, 1)))}) {
        for (const auto& [name, construct] : every_construction()) {
            CAPTURE(name);
            CHECK(construct(map, {}) == constant[0]);
        }
    }
}

TEST_CASE("the least number of 64 bits, whose magnitude is beyond them", "[blossom]") {
    const Rational least(-(Integer(1) << 63));
    const std::vector<Coordinates> line{{0}, {least}};
    for (const auto& [name, construct] : every_construction()) {
        CAPTURE(name);
        CHECK(construct(PolynomialCurve(line), {Direction(-1)}) == Coordinates{-least});
        CHECK(construct(PolynomialCurve(line), {Direction(1)}) == Coordinates{least});
        CHECK(construct(BezierCurve(line, Interval(0, 1)), {Argument(-1, -1)}) == Coordinates{-least});
    }
}

TEST_CASE("the same polynomial has different blossoms for different formal degrees", "[blossom]") {
    const Polynomial t = Polynomial::monomial(1);
    CHECK(Blossom(PolynomialCurve(t))({Parameter(3)}) == Coordinates{3});
    CHECK(Blossom(PolynomialCurve(t, 2))({Parameter(3), Parameter(5)}) == Coordinates{4});
    CHECK(Blossom(PolynomialCurve(t * t, 3))({Parameter(1), Parameter(2), Parameter(3)}) ==
          Coordinates{Rational(11, 3)});
}

TEST_CASE("a prepared blossom has its degree and dimension and can be evaluated again", "[blossom]") {
    const std::vector<Coordinates> points{{0, 0, 1}, {1, 2, 1}, {3, 1, 1}};
    const Blossom blossom(BezierCurve(points, Interval(-1, 1)));
    CHECK(blossom.degree() == 2);
    CHECK(blossom.dimension() == 3);
    const Coordinates first = blossom({Parameter(-1), Parameter(1)});
    CHECK(first == points[1]);
    CHECK(blossom({Parameter(1), Parameter(1)}) == points[2]);
    CHECK(blossom({Parameter(-1), Parameter(1)}) == first);
}

TEST_CASE("hart-nparams: a blossom takes as many arguments as its formal degree", "[blossom]") {
    const Polynomial t = Polynomial::monomial(1);
    const PolynomialMap map = PolynomialCurve(t * t);
    for (const std::size_t n : {0U, 1U, 3U}) {
        const std::vector<Argument> list = with_copies({}, n, Parameter(1));
        for (const auto& [name, construct] : every_construction()) {
            CAPTURE(name, n);
            const auto error = failure([&] { construct(map, list); });
            REQUIRE(error);
            CHECK(error->code() == ErrorCode::wrong_arity);
            CHECK(error->place() == Part::arguments);
        }
    }
}

TEST_CASE("constructions have names", "[blossom]") {
    CHECK(construction_name(Construction::symmetric) == "symmetric");
    CHECK(construction_name(Construction::polarization) == "polarization");
    CHECK(construction_name(Construction::casteljau) == "casteljau");
}
