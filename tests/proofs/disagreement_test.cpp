#include "certificates/points/point_comparison.hpp"
#include "proofs/decided.hpp"

// The linker replaces the second road by one that lies.

using namespace blossom;
using namespace blossom::testing;
using proofs::second::Comparison;

namespace {

std::optional<Comparison::Result> lie;

/// Makes the second road lie during its lifetime.
class Lie {
public:
    explicit Lie(Comparison::Result result) { lie = result; }
    Lie(const Lie&) = delete;
    Lie& operator=(const Lie&) = delete;
    Lie(Lie&&) = delete;
    Lie& operator=(Lie&&) = delete;
    ~Lie() { lie.reset(); }
};

using NamedValues = std::vector<std::pair<std::string, Rational>>;

}  // namespace

#define BLOSSOM_COMPARE \
    "_ZN7blossom6proofs6second7compareERKNS1_7ReadingERKNS1_4CaseERKSt6vectorINS1_4StepESaIS9_EEmm"
#define BLOSSOM_CONFIRM                                                                              \
    "_ZN7blossom6proofs6second7confirmERKNS1_7ReadingERKNS1_4CaseERKSt6vectorISt4pairINSt7__"        \
    "cxx1112basic_stringIcSt11char_traitsIcESaIcEEENS_8RationalEESaISH_EERKS8_ISF_SaISF_EERKS8_INS1" \
    "_4StepESaISQ_EE"

Comparison real_compare(const proofs::second::Reading& reading, const proofs::second::Case& which,
                        const std::vector<proofs::second::Step>& hint, std::size_t points,
                        std::uint64_t seed) asm("__real_" BLOSSOM_COMPARE);
Comparison lying_compare(const proofs::second::Reading& reading, const proofs::second::Case& which,
                         const std::vector<proofs::second::Step>& hint, std::size_t points,
                         std::uint64_t seed) asm("__wrap_" BLOSSOM_COMPARE);
Comparison lying_compare(const proofs::second::Reading& reading, const proofs::second::Case& which,
                         const std::vector<proofs::second::Step>& hint, std::size_t points,
                         std::uint64_t seed) {
    return lie ? Comparison{*lie, 1, "a lie"} : real_compare(reading, which, hint, points, seed);
}

Comparison real_confirm(const proofs::second::Reading& reading, const proofs::second::Case& which,
                        const NamedValues& values, const std::vector<std::string>& algebraic,
                        const std::vector<proofs::second::Step>& hint) asm("__real_" BLOSSOM_CONFIRM);
Comparison lying_confirm(const proofs::second::Reading& reading, const proofs::second::Case& which,
                         const NamedValues& values, const std::vector<std::string>& algebraic,
                         const std::vector<proofs::second::Step>& hint) asm("__wrap_" BLOSSOM_CONFIRM);
Comparison lying_confirm(const proofs::second::Reading& reading, const proofs::second::Case& which,
                         const NamedValues& values, const std::vector<std::string>& algebraic,
                         const std::vector<proofs::second::Step>& hint) {
    return lie ? Comparison{*lie, 1, "a lie"} : real_confirm(reading, which, values, algebraic, hint);
}

TEST_CASE("a verdict that the second road contradicts is not given") {
    const Lie differ(Comparison::Result::differ);
    const auto decisions = decided("map b degree 1\nclaim b[t] == b(t)");
    CHECK(decisions.at(0).verdict() == proofs::Verdict::disagreement);
    CHECK_FALSE(decisions[0].as_expected());
    CHECK(decisions[0].error()->message().find("a lie") != std::string::npos);
}

TEST_CASE("a counterexample that the second road does not confirm is not given") {
    const Lie agree(Comparison::Result::agree);
    const auto decisions = decided("map b degree 1\nclaim b[t] == b(0)\nrefute b[t] == b(0)");
    for (const proofs::Decision& decision : decisions) {
        CHECK(decision.verdict() == proofs::Verdict::disagreement);
        CHECK_FALSE(decision.as_expected());
        CHECK(decision.counterexample() == nullptr);
    }
}

TEST_CASE("where the second road finds no point nothing is decided") {
    const Lie no_point(Comparison::Result::no_point);
    const auto decisions = decided("map b degree 1\nclaim b[t] == b(t)");
    CHECK(decisions.at(0).verdict() == proofs::Verdict::undecided);
}
