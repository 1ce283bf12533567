#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include "core_test.hpp"

// Results with too many digits are refused before they are computed.

namespace {

const Integer huge = pow(Integer(10), 500'000);

void check_refused(const std::function<void()>& action) {
    CHECK(failure_code(action) == ErrorCode::limit_exceeded);
}

}  // namespace

TEST_CASE("values of too many digits are refused", "[blossom][limits]") {
    const PolynomialCurve power(Polynomial::monomial(100));
    const std::vector<Argument> arguments = with_copies({}, 100, Parameter(huge));
    const std::vector<Argument> small_ones = with_copies({}, 100, Parameter(Rational(1, huge)));
    const std::size_t before = peak_memory();
    for (const auto& [name, construct] : every_construction()) {
        CAPTURE(name);
        check_refused([&] { construct(power, arguments); });
        check_refused([&] { construct(power, small_ones); });
    }
    check_refused([&] { evaluate(power, Parameter(huge)); });
    check_refused([&] { evaluate(power, Rational(1, huge)); });
    check_refused([&] { derivative(power, 1, Parameter(huge)); });
    check_refused([&] { control_points(power, Interval(0, huge)); });
    check_refused([&] { control_points(power, Interval(Rational(1, huge), 1)); });
    CHECK(peak_memory() < before + 64);
}

TEST_CASE("an interval of too many digits counts like an argument", "[blossom][limits]") {
    const BezierCurve curve(std::vector<Coordinates>(101, Coordinates{1}), Interval(Rational(1, huge), huge));
    const std::vector<Argument> arguments = with_copies({}, 100, Parameter(1));
    const std::size_t before = peak_memory();
    for (const auto& [name, construct] : every_construction()) {
        CAPTURE(name);
        check_refused([&] { construct(curve, arguments); });
    }
    check_refused([&] { evaluate(curve, 1); });
    check_refused([&] { monomial_form(curve); });
    check_refused([&] { control_points(curve, Interval(0, 1)); });
    CHECK(peak_memory() < before + 64);
}

TEST_CASE("the limit of digits is the caller's", "[blossom][limits]") {
    const PolynomialCurve square(Polynomial::monomial(2));
    Limits limits;
    limits.digits = 50;
    const Parameter fine(pow(Integer(10), 12));
    const Parameter large(pow(Integer(10), 40));
    CHECK_FALSE(failure([&] { evaluate(square, fine, limits); }));
    check_refused([&] { evaluate(square, large, limits); });
    for (const Construction construction :
         {Construction::symmetric, Construction::polarization, Construction::casteljau}) {
        CHECK_FALSE(failure([&] { blossom_value(square, with_copies({}, 2, fine), construction, limits); }));
        check_refused([&] { blossom_value(square, with_copies({}, 2, large), construction, limits); });
    }
}

TEST_CASE("many numbers that are each within the limit are refused together", "[blossom][limits]") {
    // 10^4 control points of up to 10^5 digits
    const PolynomialCurve curve(Polynomial(1), 9'999);
    const Rational end(pow(Integer(10), 5));
    const std::size_t before = peak_memory();
    check_refused([&] { control_points(curve, Interval(0, end)); });
    check_refused([&] { taylor_form(curve, end); });
    check_refused([&] { subdivide(BezierCurve(curve.coefficients(), Interval()), end); });
    check_refused(
        [&] { elevate(BezierCurve(std::vector<Coordinates>(2, Coordinates{huge * huge})), 2'000); });
    CHECK(peak_memory() < before + 64);

    Limits limits;
    limits.output_digits = 8 * 40;
    const PolynomialCurve cubic(std::vector<Coordinates>{{pow(Integer(10), 30)}, {0}, {0}, {1}});
    CHECK_FALSE(failure([&] { agreement_for_all_arguments(cubic, limits); }));
    CHECK_FALSE(failure([&] { elementary_symmetric_form(cubic, limits); }));
    limits.output_digits = 8 * 30;
    check_refused([&] { agreement_for_all_arguments(cubic, limits); });
    limits.output_digits = 4 * 30;
    check_refused([&] { elementary_symmetric_form(cubic, limits); });
}

TEST_CASE("a formal degree beyond the limit is refused", "[blossom][limits]") {
    Limits limits;
    limits.degree = 5;
    CHECK_FALSE(failure([&] { Blossom(PolynomialCurve(Polynomial(1), 5), limits); }));
    const auto error = failure([&] { Blossom(PolynomialCurve(Polynomial(1), 6), limits); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::limit_exceeded);
    CHECK(error->place() == Part::degree);
}
