#include "logarithms.hpp"

#include <algorithm>
#include <stdexcept>

namespace blossom::testing {

namespace {

/// 2 artanh(x) = 2 sum x^(2k+1) / (2k+1) for 0 < x < 1; a geometric series bounds the omitted terms.
Enclosure twice_artanh(const Rational& x) {
    Rational sum;
    Rational power = x;
    std::size_t odd = 1;
    const Rational enough = 1 / pow(Rational(10), 50);
    while (power > enough) {
        sum += 2 * power / Rational(odd);
        power *= x * x;
        odd += 2;
    }
    return {sum, sum + 2 * power / (Rational(odd) * (1 - x * x))};
}

int remove_factor(Integer& number, int prime) {
    int count = 0;
    while ((number % Integer(prime)).is_zero()) {
        number /= Integer(prime);
        ++count;
    }
    return count;
}

}  // namespace

Enclosure operator+(const Enclosure& a, const Enclosure& b) { return {a.lower + b.lower, a.upper + b.upper}; }
Enclosure operator-(const Enclosure& a, const Enclosure& b) { return {a.lower - b.upper, a.upper - b.lower}; }
Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    const auto [least, greatest] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return {least, greatest};
}

Coordinates logarithm(const Rational& t) {
    Integer numerator = t.numerator();
    Integer denominator = t.denominator();
    Coordinates result{0};
    for (const int prime : {2, 3, 5}) {
        const int above = remove_factor(numerator, prime);
        result.emplace_back(above - remove_factor(denominator, prime));
    }
    if (!numerator.is_one() || !denominator.is_one()) throw std::domain_error("a prime factor above 5");
    return result;
}

// ln((1 + x) / (1 - x)) = 2 artanh(x): ln 2 by x = 1/3, ln(3/2) by 1/5, ln(5/4) by 1/9.
Enclosure enclosed(const Coordinates& combination) {
    static const Enclosure ln2 = twice_artanh({1, 3});
    static const Enclosure ln3 = ln2 + twice_artanh({1, 5});
    static const Enclosure ln5 = ln2 + ln2 + twice_artanh({1, 9});
    return Enclosure(combination[0]) + Enclosure(combination[1]) * ln2 + Enclosure(combination[2]) * ln3 +
           Enclosure(combination[3]) * ln5;
}

}  // namespace blossom::testing
