#include "residue_operations.hpp"

namespace blossom::residues {

namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t low_52 = (std::uint64_t{1} << 52) - 1;

struct Portable {
    using Vector = Octet;
    struct Accumulator {
        Wide lane[lanes];
    };

    static Octet load(const Octet& from) { return from; }
    static Octet broadcast(std::uint64_t value) {
        Octet result{};
        for (std::uint64_t& lane : result.lane) lane = value;
        return result;
    }
    static void add_product(Accumulator& sum, const Octet& a, const Octet& b) {
        for (std::size_t i = 0; i < lanes; ++i) sum.lane[i] += Wide{a.lane[i]} * b.lane[i];
    }
    static void add(Accumulator& sum, const Accumulator& other) {
        for (std::size_t i = 0; i < lanes; ++i) sum.lane[i] += other.lane[i];
    }
    static Octet negated(const Moduli& moduli, const Octet& residues) {
        Octet result{};
        for (std::size_t i = 0; i < lanes; ++i)
            result.lane[i] = residues.lane[i] == 0 ? 0 : moduli.prime.lane[i] - residues.lane[i];
        return result;
    }
    static Octet reduced(const Moduli& moduli, const Accumulator& sum) {
        Octet result{};
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::uint64_t prime = moduli.prime.lane[i];
            const std::uint64_t multiple =
                (static_cast<std::uint64_t>(sum.lane[i]) * moduli.negative_inverse.lane[i]) & low_52;
            const auto quotient = static_cast<std::uint64_t>((sum.lane[i] + Wide{multiple} * prime) >> 52);
            const std::uint64_t folded = (quotient & low_50) + (quotient >> 50) * moduli.delta.lane[i];
            result.lane[i] = folded >= prime ? folded - prime : folded;
        }
        return result;
    }
};

}  // namespace

const Operations portable_operations = OperationsOf<Portable>::table;

}  // namespace blossom::residues
