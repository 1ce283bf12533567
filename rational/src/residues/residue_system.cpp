#include "residue_system.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <deque>
#include <mutex>

#include "limbs/limb_arithmetic.hpp"
#include "modular_words.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom::residues {

namespace {

using modular::power;
using modular::product;

/// The test of Miller and Rabin; these bases decide for 64 bits (Sorenson and Webster, 2015).
bool is_prime(std::uint64_t odd) {
    const int twos = std::countr_zero(odd - 1);
    for (const std::uint64_t base : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U}) {
        std::uint64_t x = power(base, (odd - 1) >> twos, odd);
        bool passes = x == 1 || x == odd - 1;
        for (int i = 1; i < twos && !passes; ++i) {
            x = product(x, x, odd);
            passes = x == odd - 1;
        }
        if (!passes) return false;
    }
    return true;
}

/// A root of unity of order 2^order modulo a prime that is congruent to 1 modulo 2^order.
std::uint64_t root_of_unity(std::uint64_t prime, std::size_t order) {
    for (std::uint64_t base = 2;; ++base) {
        const std::uint64_t root = power(base, (prime - 1) >> order, prime);
        if (power(root, std::uint64_t{1} << (order - 1), prime) == prime - 1) return root;
    }
}

/// The groups of primes in use, which do not move once they are created; only one thread may use this object
/// at a time.
class Groups {
public:
    const Moduli& group(std::size_t i) {
        while (groups_.size() <= i) append();
        return groups_[i];
    }
    /// The least number of groups with a product of at least 2^bits.
    std::size_t count_for(std::size_t bits) {
        while (bits_.empty() || bits_.back() < bits) append();
        return static_cast<std::size_t>(std::ranges::lower_bound(bits_, bits) - bits_.begin()) + 1;
    }

private:
    /// Primes that are 1 modulo 2^root_order come first.
    void step_to_prime(const Operations& level) {
        const std::uint64_t end = std::uint64_t{1} << level.delta_bits;
        const std::uint64_t order = std::uint64_t{1} << level.root_order;
        for (;;) {
            delta_ += has_roots_ ? order : 2;
            if (delta_ >= end) {
                if (!has_roots_) {
                    throw Error(ErrorCode::limit_exceeded,
                                "there are not enough primes for integers of this size");
                }
                has_roots_ = false;
                delta_ = static_cast<std::uint64_t>(-1);
            } else if ((has_roots_ || (delta_ + 1) % order != 0) &&
                       is_prime((std::uint64_t{1} << level.prime_bits) - delta_)) {
                return;
            }
        }
    }
    void append() {
        const Operations& level = operations();
        const std::uint64_t power = std::uint64_t{1} << level.prime_bits;
        const std::uint64_t mask = (std::uint64_t{1} << level.radix_bits) - 1;
        Moduli group{};
        group.root_order = level.root_order;
        Integer product_of_all = 1;
        for (std::size_t i = 0; i < lanes; ++i) {
            step_to_prime(level);
            if (!has_roots_) group.root_order = 0;
            const std::uint64_t prime = power - delta_;
            const std::uint64_t radix = (mask + 1) % prime;
            group.prime.lane[i] = prime;
            group.delta.lane[i] = delta_;
            if (has_roots_) {
                group.root.lane[i] = product(root_of_unity(prime, level.root_order), radix, prime);
            }
            group.inverse.lane[i] = inverse_of_odd(prime) & mask;
            group.radix.lane[i] = radix;
            group.square.lane[i] = product(radix, radix, prime);
            product_of_all *= prime;
        }
        groups_.push_back(group);
        bits_.push_back((bits_.empty() ? 0 : bits_.back()) + product_of_all.bit_length() - 1);
    }

    std::deque<Moduli> groups_;
    std::vector<std::size_t> bits_;  ///< the product of the first i + 1 groups is at least 2^bits_[i]
    std::uint64_t delta_ = static_cast<std::uint64_t>(-1);
    bool has_roots_ = true;
};

template <class Use>
decltype(auto) with_groups(const Use& use) {
    static std::mutex mutex;
    static Groups groups;
    const std::lock_guard lock(mutex);
    return use(groups);
}

/// first, first * 2^b, first * 2^2b, ...
std::vector<ResidueVector> powers(const Moduli& moduli, std::size_t count, const ResidueVector& first) {
    std::vector<ResidueVector> result(std::max(count, std::size_t{1}));
    result[0] = first;
    // 2^(b done) times the radix
    ResidueVector step{};
    operations().scale(moduli, &moduli.square, moduli.delta, 1, &step);
    for (std::size_t done = 1; done < result.size(); done *= 2) {
        operations().scale(moduli, result.data(), step, std::min(done, result.size() - done),
                           result.data() + done);
        operations().scale(moduli, &step, step, 1, &step);
    }
    return result;
}

}  // namespace

const Moduli& moduli(std::size_t group) {
    return with_groups([&](Groups& groups) -> const Moduli& { return groups.group(group); });
}

std::size_t groups_for(std::size_t bits) {
    return with_groups([&](Groups& groups) { return groups.count_for(bits + 1); });
}

void Digits::reserve(std::size_t values, std::size_t digits_of_one) {
    digits_.reserve(digits_of_one * values);
    begins_.reserve(values + 1);
    negative_.reserve(values);
}

void Digits::finish(bool negative) {
    most_digits_ = std::max(most_digits_, digits_.size() - begins_.back());
    begins_.push_back(digits_.size());
    negative_.push_back(negative);
}

void Digits::push_back(Int128 value) {
    const std::size_t bits = operations().prime_bits;
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    for (UInt128 rest = magnitude(value); rest != 0; rest >>= bits)
        digits_.push_back(static_cast<std::uint64_t>(rest) & mask);
    finish(value < 0);
}

void Digits::push_back(const Integer& value) {
    if (const auto word = value.to_int64()) return push_back(Int128{*word});
    const std::size_t digit_bits = operations().prime_bits;
    const std::uint64_t mask = (std::uint64_t{1} << digit_bits) - 1;
    const std::size_t bits = value.bit_length();
    words_.resize(bits / 64 + 2);
    limbs::write_magnitude(value, words_.data(), words_.size());
    for (std::size_t bit = 0; bit < bits; bit += digit_bits) {
        const std::size_t word = bit / 64;
        const UInt128 pair = UInt128{words_[word + 1]} << 64 | words_[word];
        digits_.push_back(static_cast<std::uint64_t>(pair >> (bit % 64)) & mask);
    }
    finish(value.sign() < 0);
}

void Digits::residues(const Moduli& moduli, const ResidueVector* powers, ResidueVector* residues) const {
    const Operations& run = operations();
    if (most_digits_ <= most_terms) {
        run.residues_of_digits(moduli, digits_.data(), begins_.data(), size(), powers, residues);
    } else {
        for (std::size_t i = 0; i < size(); ++i) {
            residues[i] = ResidueVector{};
            for (std::size_t begin = begins_[i]; begin < begins_[i + 1]; begin += most_terms) {
                const std::size_t piece[] = {begin, std::min(begin + most_terms, begins_[i + 1])};
                ResidueVector part{};
                run.residues_of_digits(moduli, digits_.data(), piece, 1, powers + (begin - begins_[i]),
                                       &part);
                run.add(moduli, &residues[i], &part, 1, &residues[i]);
            }
        }
    }
    const ResidueVector zero{};
    for (std::size_t i = 0; i < size(); ++i)
        if (negative_[i]) run.subtract(moduli, &zero, &residues[i], 1, &residues[i]);
}

std::vector<ResidueVector> plain_powers(const Moduli& moduli, std::size_t count) {
    return powers(moduli, count, moduli.radix);
}

std::vector<ResidueVector> montgomery_powers(const Moduli& moduli, std::size_t count) {
    return powers(moduli, count, moduli.square);
}

}  // namespace blossom::residues
