// The blossom of 1 + 2t + 4t^2 - t^3 at 1, 2, 3.

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/blossom/blossom.hpp>

#include <cstdio>

int main() {
    using blossom::Parameter;
    const auto curve = blossom::parse_univariate("1 + 2t + 4t^2 - t^3").polynomial;
    const blossom::Blossom p{blossom::PolynomialCurve(curve)};
    std::puts(to_string(p({Parameter(1), Parameter(2), Parameter(3)}).front()).c_str());
}
