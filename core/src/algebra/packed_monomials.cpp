#include "packed_monomials.hpp"

#include <algorithm>

namespace blossom::packed_monomials {

namespace {

using Words = std::vector<std::uint64_t>;

Words with_words(std::span<const std::uint64_t> monomials, std::size_t words, std::size_t new_words) {
    if (words == 0) return {};
    Words result(monomials.size() / words * new_words);
    auto to = result.begin();
    for (std::size_t i = 0; i < monomials.size(); i += words) {
        std::ranges::copy(monomials.subspan(i, std::min(words, new_words)), to);
        to += static_cast<std::ptrdiff_t>(new_words);
    }
    return result;
}

Words widened(std::span<const std::uint64_t> monomials, std::size_t bits) {
    Words result;
    result.reserve(2 * monomials.size());
    for (const std::uint64_t word : monomials) {
        result.push_back(spread(word >> 32, bits));
        result.push_back(spread(word & 0xffff'ffff, bits));
    }
    return result;
}

/// For an even number of words per monomial.
Words narrowed(std::span<const std::uint64_t> monomials, std::size_t bits) {
    Words result;
    result.reserve(monomials.size() / 2);
    for (std::size_t i = 0; i < monomials.size(); i += 2) {
        result.push_back(gathered(monomials[i], bits / 2) << 32 | gathered(monomials[i + 1], bits / 2));
    }
    return result;
}

}  // namespace

Words rewritten(std::span<const std::uint64_t> monomials, std::size_t words, std::size_t bits,
                std::size_t new_words, std::size_t new_bits) {
    if (words == 0) return {};
    Words result(monomials.begin(), monomials.end());
    for (; bits < new_bits; bits *= 2) {
        result = widened(result, bits);
        words *= 2;
    }
    for (; bits > new_bits; bits /= 2) {
        if (words % 2 == 1) {
            result = with_words(result, words, words + 1);
            ++words;
        }
        result = narrowed(result, bits);
        words /= 2;
    }
    return words == new_words ? result : with_words(result, words, new_words);
}

Words greatest_exponents(std::span<const std::uint64_t> monomials, std::size_t words, std::size_t bits) {
    if (words == 0) return {};
    return with_width(words, [&](const auto& width) {
        auto greatest = width.monomial();
        for (std::size_t i = 0; i < monomials.size(); i += width.words()) {
            for (std::size_t j = 0; j < width.words(); ++j)
                greatest[j] = greater_exponents(greatest[j], monomials[i + j], bits);
        }
        return Words(greatest.begin(), greatest.end());
    });
}

}  // namespace blossom::packed_monomials
