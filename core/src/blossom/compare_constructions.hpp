#pragma once

#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/constructions/constructions.hpp>

#include <initializer_list>
#include <string>
#include <utility>

namespace blossom {

/// Runs the constructions; `excess(construction)` says why one is not run, or nothing.
template <class Value, class Excess, class Run>
Agreement<Value> collected_agreement(const Excess& excess, const Run& run,
                                     std::initializer_list<Construction> constructions = {
                                         Construction::symmetric, Construction::polarization,
                                         Construction::casteljau}) {
    Agreement<Value> agreement;
    for (const Construction construction : constructions) {
        std::string reason = excess(construction);
        if (reason.empty()) {
            agreement.results.push_back({construction, run(construction), {}});
        } else {
            agreement.results.push_back({construction, std::nullopt, std::move(reason)});
        }
    }
    return agreement;
}

/// Why polarization is not run where it needs this many terms, or nothing.
std::string polarization_excess(std::size_t terms, const Limits& limits);
/// Why a symbolic polarization of this many term operations is not run, or nothing.
std::string symbolic_excess(const Integer& work, const Limits& limits);

/// Numerators over one integer as polynomials.
std::vector<SparsePolynomial> quotients(Quotients<SparsePolynomial> value);

/// run(construction) on symbolic arguments; polarization takes `work` term operations there.
template <class Run>
Agreement<std::vector<SparsePolynomial>> symbolic_agreement(const Integer& work, const Limits& limits,
                                                            const Run& run) {
    const auto excess = [&](Construction construction) -> std::string {
        return construction == Construction::polarization ? symbolic_excess(work, limits) : "";
    };
    return collected_agreement<std::vector<SparsePolynomial>>(
        excess, [&](Construction construction) { return quotients(run(construction)); });
}

}  // namespace blossom
