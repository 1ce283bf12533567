#include <blossom/rational/resource_budget.hpp>

#include "subset_residues.hpp"

namespace blossom::subset_sums {

namespace {

/// For larger results, arithmetic on large integers is faster.
constexpr std::size_t most_regrouped_bits = 1'000'000;

/// a_Nk = sum (-1)^(n-|S|) (sum of S)^k / k! over the sub-multisets S with N points, modulo eight primes.
class PowerSums {
public:
    PowerSums(const Moduli& moduli, std::size_t n)
        : moduli_(moduli), size_(n + 1), sums_(size_ * size_), powers_(size_), inverse_(size_) {
        std::ranges::fill(sums_, residue_vector_of(0));
        sums_[0] = residue_vector_of(1);
        for (std::size_t l = 0; l < residues::lanes; ++l) {
            const PrimeField field(moduli.prime.lane[l]);
            for (std::size_t j = 1; j < size_; ++j)
                inverse_[j].lane[l] = field.product(field.inverse(j), moduli.square.lane[l]);
        }
    }

    /// Appends an argument: the sets without it change sign, and e^((u + x) t) = e^(u t) e^(x t) gives those
    /// with it.
    void append(const ResidueVector& parameter, bool point) {
        // x^j / j! in reverse order, highest j first, times the radix.
        ResidueVector factor{};
        powers_[size_ - 1] = moduli_.radix;
        for (std::size_t j = 1; j < size_; ++j) {
            operations().scale(moduli_, &parameter, inverse_[j], 1, &factor);
            operations().scale(moduli_, &powers_[size_ - j], factor, 1, &powers_[size_ - 1 - j]);
        }
        points_ += point ? 1 : 0;
        const ResidueVector zero = residue_vector_of(0);
        for (std::size_t points = points_ + 1; points-- > 0;) {
            spend_work(residues::lanes * size_ * size_ / 2);
            ResidueVector* row = sums_.data() + points * size_;
            const bool grows = !point || points > 0;
            const ResidueVector* smaller = point && grows ? row - size_ : row;
            for (std::size_t k = size_; k-- > 0;) {
                const ResidueVector larger =
                    grows ? operations().dot(moduli_, smaller, &powers_[size_ - 1 - k], k + 1) : zero;
                operations().subtract(moduli_, &larger, &row[k], 1, &row[k]);
            }
        }
    }

    /// sum_N N^(n-k) a_Nk for each k.
    std::vector<ResidueVector> weighted_by_points() const {
        std::vector<ResidueVector> result(size_, residue_vector_of(0));
        for (std::size_t points = 0; points <= points_; ++points) {
            ResidueVector number{};
            for (std::size_t l = 0; l < residues::lanes; ++l)
                number.lane[l] = PrimeField(moduli_.prime.lane[l]).product(points, moduli_.radix.lane[l]);
            ResidueVector power = moduli_.radix;
            for (std::size_t k = size_; k-- > 0;) {
                ResidueVector term{};
                operations().scale(moduli_, &sums_[points * size_ + k], power, 1, &term);
                operations().add(moduli_, &result[k], &term, 1, &result[k]);
                operations().scale(moduli_, &power, number, 1, &power);
            }
        }
        return result;
    }

private:
    const Moduli& moduli_;
    std::size_t size_;
    std::size_t points_ = 0;
    std::vector<ResidueVector> sums_;  ///< one row per number of points
    std::vector<ResidueVector> powers_;
    std::vector<ResidueVector> inverse_;  ///< 1/j times the square of the radix
};

std::optional<std::vector<Integer>> regrouped(Rows rows, Groups groups) {
    const std::size_t n = number_of_arguments(groups);
    const std::size_t bits = result_bits(rows, groups);
    if (bits > most_regrouped_bits || n >= residues::most_terms) return std::nullopt;
    std::vector<std::vector<ResidueVector>> residues_of_sums(rows.size());
    const std::size_t prime_groups = residues::groups_for(bits);
    for (std::size_t g = 0; g < prime_groups; ++g) {
        const Moduli& primes = moduli(g);
        PowerSums sums(primes, n);
        ResidueVector masses = residue_vector_of(1);
        for (const SubsetGroup& group : groups) {
            ResidueVector parameter{};
            for (std::size_t l = 0; l < residues::lanes; ++l) {
                const PrimeField field(primes.prime.lane[l]);
                const auto residue = group_residue(field, group);
                if (!residue) return std::nullopt;
                parameter.lane[l] = residue->parameter;
                masses.lane[l] =
                    field.product(masses.lane[l], field.power(residue->mass, group.multiplicity));
            }
            for (std::size_t i = 0; i < group.multiplicity; ++i)
                sums.append(parameter, !group.mass.is_zero());
        }
        const std::vector<ResidueVector> weighted = sums.weighted_by_points();
        for (std::size_t j = 0; j < rows.size(); ++j) {
            ResidueVector total = residue_vector_of(0);
            for (std::size_t l = 0; l < residues::lanes; ++l) {
                const PrimeField field(primes.prime.lane[l]);
                std::uint64_t factor = masses.lane[l];  // times k!
                for (std::size_t k = 0; k <= n; ++k) {
                    if (k > 0) factor = field.product(factor, k);
                    const std::uint64_t coefficient = field.product(field.of(rows[j][k]), factor);
                    total.lane[l] = field.sum(
                        total.lane[l], field.product(coefficient, weighted[k].lane[l] % field.prime()));
                }
            }
            residues_of_sums[j].push_back(total);
        }
    }
    std::vector<Integer> result;
    result.reserve(rows.size());
    for (const auto& residues : residues_of_sums) result.push_back(residues::integer_with(residues));
    return result;
}

}  // namespace

}  // namespace blossom::subset_sums

namespace blossom {

std::optional<std::vector<Integer>> regrouped_subset_sums(subset_sums::Rows rows,
                                                          subset_sums::Groups groups) {
    return subset_sums::regrouped(rows, groups);
}

}  // namespace blossom
