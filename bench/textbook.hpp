#pragma once

#include <cstddef>
#include <vector>

/// The loops of the literature on rational numbers, without common denominators: each operation reduces its
/// result.
namespace textbook {

template <class Number>
using Numbers = std::vector<Number>;

/// sum_k c_k e_k(u) / C(n, k), the e_k by the usual recurrence.
template <class Number>
Number symmetric(const Numbers<Number>& coefficients, const Numbers<Number>& arguments) {
    const std::size_t n = arguments.size();
    Numbers<Number> elementary(n + 1);
    elementary[0] = 1;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i + 1; k > 0; --k) elementary[k] += arguments[i] * elementary[k - 1];
    }
    Number sum = 0;
    Number binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        sum += coefficients[k] * elementary[k] / binomial;
        binomial = binomial * (n - k) / (k + 1);
    }
    return sum;
}

/// DeRose's figure 6 over [0, 1].
template <class Number>
Number casteljau(Numbers<Number> points, const Numbers<Number>& arguments) {
    for (std::size_t level = 0; level < arguments.size(); ++level) {
        const Number& u = arguments[level];
        for (std::size_t j = 0; j + level < arguments.size(); ++j) {
            points[j] = (1 - u) * points[j] + u * points[j + 1];
        }
    }
    return points[0];
}

template <class Number>
Number value(const Numbers<Number>& coefficients, const Number& t) {
    Number sum = 0;
    for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * t + coefficients[k];
    return sum;
}

/// (1/n!) times the sum over subsets of (-1)^(n-N) N^n P(mean), one subset after the other.
template <class Number>
Number polarization(const Numbers<Number>& coefficients, const Numbers<Number>& arguments) {
    const std::size_t n = arguments.size();
    Number sum = 0;
    for (std::size_t subset = 1; subset < std::size_t{1} << n; ++subset) {
        Number total = 0;
        unsigned count = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if ((subset >> i & 1) == 0) continue;
            total += arguments[i];
            ++count;
        }
        Number term = value(coefficients, Number(total / count));
        for (std::size_t i = 0; i < n; ++i) term *= count;
        (n - count) % 2 == 0 ? sum += term : sum -= term;
    }
    for (std::size_t k = 2; k <= n; ++k) sum /= k;
    return sum;
}

/// De Boor's algorithm on the span between knots i and i + 1, in the textbook convention.
template <class Number>
Number de_boor(const Numbers<Number>& knots, const Numbers<Number>& points, std::size_t degree,
               std::size_t span, const Number& t) {
    Numbers<Number> d(points.begin() + static_cast<std::ptrdiff_t>(span - degree),
                      points.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t level = 1; level <= degree; ++level) {
        for (std::size_t j = degree; j >= level; --j) {
            const Number& begin = knots[span - degree + j];
            const Number weight = (t - begin) / (knots[span + 1 + j - level] - begin);
            d[j] = (1 - weight) * d[j - 1] + weight * d[j];
        }
    }
    return d[degree];
}

}  // namespace textbook
