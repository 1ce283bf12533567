#include "word_factors.hpp"

namespace blossom {

// For b < a all three of a, b and q change sign: the factor and its denominator b - a then do as well.
WordFrame::WordFrame(const ClearedInterval& interval) : kind_(Kind::beyond_words) {
    const Integer length = interval.b - interval.a;
    const Integer sign = length.sign();
    const Integer numbers[] = {interval.a * sign, interval.b * sign, interval.q * sign, length * sign};
    for (const Integer& number : numbers)
        if (!number.is_word() || number.word() == least_word) return;
    kind_ = Kind::interval;
    a_ = numbers[0].word();
    b_ = numbers[1].word();
    q_ = numbers[2].word();
    length_ = numbers[3].word();
}

bool WordFrame::read_over_interval(std::int64_t u, std::int64_t mass, std::int64_t scale,
                                   WordFactor& factor) const {
    std::int64_t x = 0;
    std::int64_t from_a = 0;
    std::int64_t to_b = 0;
    bool overflow = __builtin_mul_overflow(q_, u, &x);
    overflow |= __builtin_mul_overflow(a_, mass, &from_a);
    overflow |= __builtin_mul_overflow(b_, mass, &to_b);
    overflow |= __builtin_sub_overflow(to_b, x, &factor.constant);
    overflow |= __builtin_sub_overflow(x, from_a, &factor.slope);
    overflow |= __builtin_mul_overflow(length_, scale, &factor.denominator);
    return !overflow && factor.constant != least_word && factor.slope != least_word;
}

}  // namespace blossom
