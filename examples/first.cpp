// The blossom of 1 + 2t + 4t^2 - t^3: values, control points, a derivative, and the agreement of three
// constructions.

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/derivative.hpp>

#include <cstdio>

int main() {
    using namespace blossom;

    const Polynomial polynomial = parse_univariate("1 + 2t + 4t^2 - t^3").polynomial;
    const PolynomialCurve curve(polynomial);
    const Blossom p(curve);

    std::printf("p(1, 2, 3) = %s\n", to_string(p({Parameter(1), Parameter(2), Parameter(3)})[0]).c_str());
    std::printf("p(1, 2, delta) = %s\n", to_string(p({Parameter(1), Parameter(2), delta})[0]).c_str());

    const BezierCurve bezier = control_points(curve, Interval(0, 1));
    for (const Coordinates& point : bezier.control_points().to_points()) {
        std::printf("control point %s\n", to_string(point[0]).c_str());
    }
    std::printf("P''(1/2) = %s\n", to_string(derivative(curve, 2, Parameter(Rational(1, 2)))[0]).c_str());

    const auto proof = agreement_for_all_arguments(curve);
    const auto& expansion = proof.results.front().value->front();
    std::printf("three constructions agree: %s\n", proof.agree() ? "yes" : "no");
    std::printf("%s\n", to_text(expansion, numbered_names("u", 3)).c_str());
    return proof.agree() ? 0 : 1;
}
