#include "word_factors.hpp"

#include <algorithm>

namespace blossom {

// If b < a, the signs of a, b and q are changed, which changes the signs of the factor and of its denominator
// b - a.
WordFrame::WordFrame(const ClearedInterval& interval) : kind_(Kind::beyond_words) {
    const Integer length = interval.b - interval.a;
    const Integer sign = length.sign();
    const Integer numbers[] = {interval.a * sign, interval.b * sign, interval.q * sign, length * sign};
    const auto is_too_large = [](const Integer& number) {
        return !number.is_word() || number.word() == least_word;
    };
    if (std::ranges::none_of(numbers, is_too_large)) {
        kind_ = Kind::interval;
        line_ = {numbers[0].word(), numbers[1].word(), numbers[2].word(), numbers[3].word()};
    }
}

bool WordFrame::move_to_interval(std::span<WordFactor> factors) const {
    for (WordFactor& factor : factors) {
        std::int64_t x = 0;
        std::int64_t from_a = 0;
        std::int64_t to_b = 0;
        bool overflow = __builtin_mul_overflow(line_.q, factor.slope, &x);
        overflow |= __builtin_mul_overflow(line_.a, factor.constant, &from_a);
        overflow |= __builtin_mul_overflow(line_.b, factor.constant, &to_b);
        overflow |= __builtin_sub_overflow(to_b, x, &factor.constant);
        overflow |= __builtin_sub_overflow(x, from_a, &factor.slope);
        overflow |= __builtin_mul_overflow(line_.length, factor.denominator, &factor.denominator);
        if (overflow || factor.constant == least_word || factor.slope == least_word) return false;
    }
    return true;
}

}  // namespace blossom
