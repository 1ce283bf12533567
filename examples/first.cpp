// The blossom of 1 + 2t + 4t^2 - t^3: values, control points, a derivative, and the agreement of three
// constructions.

#include <blossom/core.hpp>

#include <iostream>

int main() {
    using namespace blossom;

    const PolynomialCurve curve(Polynomial({1, 2, 4, -1}));
    const Blossom p(curve);

    std::cout << "p(1, 2, 3) = " << p({1, 2, 3})[0] << '\n';
    std::cout << "p(1, 2, delta) = " << p({1, 2, delta})[0] << '\n';
    std::cout << control_points(curve, Interval(0, 1)) << '\n';
    std::cout << "P''(1/2) = " << derivative(curve, 2, Rational(1, 2))[0] << '\n';

    const auto proof = agreement_for_all_arguments(curve);
    const auto& expansion = proof.results.front().value->front();
    std::cout << "three constructions agree: " << (proof.agree() ? "yes" : "no") << '\n';
    std::cout << to_text(expansion, numbered_names("u", 3)) << '\n';
    return proof.agree() ? 0 : 1;
}
