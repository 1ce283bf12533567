#include "taylor_shift_ntt.hpp"

#include <algorithm>
#include <deque>
#include <mutex>

#include "residue_system.hpp"

namespace blossom::residues {

ResidueVector inverse(const Moduli& moduli, const ResidueVector& x) {
    const Operations& run = operations();
    ResidueVector square = x;
    ResidueVector result = moduli.radix;
    // x^(p - 2), by repeated squaring.
    for (std::size_t bit = 0; bit < run.prime_bits; ++bit) {
        ResidueVector next{};
        run.scale(moduli, &result, square, 1, &next);
        for (std::size_t i = 0; i < lanes; ++i)
            if (((moduli.prime.lane[i] - 2) >> bit & 1) != 0) result.lane[i] = next.lane[i];
        run.scale(moduli, &square, square, 1, &square);
    }
    return result;
}

std::shared_ptr<const ShiftTables> ShiftTables::of_group(std::size_t group, std::size_t size) {
    constexpr std::size_t most_vectors = std::size_t{1} << 20;
    constexpr std::size_t vectors_a_value = 3;
    struct Kept {
        std::size_t group;
        std::shared_ptr<const ShiftTables> tables;
    };
    static std::mutex mutex;
    static std::deque<Kept> kept;
    static std::size_t vectors_kept = 0;
    {
        const std::lock_guard lock(mutex);
        const auto found = std::ranges::find_if(
            kept, [&](const Kept& one) { return one.group == group && one.tables->size() == size; });
        if (found != kept.end()) return found->tables;
    }
    auto made = std::make_shared<const ShiftTables>(residues::moduli(group), size);
    const std::lock_guard lock(mutex);
    kept.push_back({group, made});
    vectors_kept += vectors_a_value * size;
    for (; vectors_kept > most_vectors; kept.pop_front())
        vectors_kept -= vectors_a_value * kept.front().tables->size();
    return made;
}

ShiftTables::ShiftTables(const Moduli& moduli, std::size_t size)
    : moduli_(moduli),
      size_(size),
      factorials_(size / 2),
      inverse_factorials_(size / 2),
      exponential_(size),
      roots_(moduli, size) {
    const Operations& run = operations();
    ResidueVector k{};  // times the radix
    factorials_[0] = moduli.radix;
    for (std::size_t i = 1; i < factorials_.size(); ++i) {
        run.add(moduli, &k, &moduli.radix, 1, &k);
        run.scale(moduli, &factorials_[i - 1], k, 1, &factorials_[i]);
    }
    inverse_factorials_.back() = inverse(moduli, factorials_.back());
    for (std::size_t i = factorials_.size() - 1; i > 0; --i) {
        run.scale(moduli, &inverse_factorials_[i], k, 1, &inverse_factorials_[i - 1]);
        run.subtract(moduli, &k, &moduli.radix, 1, &k);
    }
    ResidueVector length{};
    for (std::uint64_t& lane : length.lane) lane = size;
    run.scale(moduli, &length, moduli.square, 1, &length);
    run.scale(moduli, inverse_factorials_.data(), inverse(moduli, length), size / 2, exponential_.data());
    run.transform(moduli, roots_.data(), exponential_.data(), size);
}

void ShiftTables::multiply_by_exponential(ResidueVector* a, std::size_t count) const {
    const Operations& run = operations();
    std::fill(a + count, a + size_, ResidueVector{});
    run.transform(moduli_, roots_.data(), a, size_);
    run.multiply_each(moduli_, a, exponential_.data(), size_, a);
    run.inverse_transform(moduli_, roots_.data(), a, size_);
}

}  // namespace blossom::residues
