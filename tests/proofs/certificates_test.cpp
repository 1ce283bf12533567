#include <blossom/proofs/certificate.hpp>
#include "decided.hpp"

#include <functional>

// A certificate is checked from the text alone, and refused after any change that makes it wrong.

using proofs::second::Branch;
using proofs::second::Certificate;
using proofs::second::NamedPolynomial;

namespace {

std::vector<Certificate> certificates_of(const std::string& text) {
    std::vector<Certificate> certificates;
    proofs::DecisionOptions options;
    options.on_proof = [&](const proofs::ProvedCase& proved) { certificates.push_back(proved.certificate); };
    const proofs::Document document = proofs::parse(text);
    REQUIRE(document.errors.empty());
    for (const proofs::Block& block : document.blocks) proofs::decide(block, {}, options);
    return certificates;
}

Certificate certificate_of_only_case(const std::string& text) {
    const auto certificates = certificates_of(text);
    REQUIRE(certificates.size() == 1);
    return certificates[0];
}

/// The problem of the certificate after a change.
std::string problem_after(const Certificate& good, const std::function<void(Certificate&)>& spoil) {
    REQUIRE(proofs::second::problem_of(good, {}).empty());
    Certificate changed = good;
    spoil(changed);
    return proofs::second::problem_of(changed, {});
}

const std::string divided = "map p degree 2\nclaim p[s, u] == (b-u)/(b-a)*p[s, a] + (u-a)/(b-a)*p[s, b]\n";
const std::string solved =
    "map f, g degree 2\ngiven f(s) == g(s)\ngiven f'(s) == g'(s)\nclaim f[x, s] == g[x, s]\n";
const std::string root = "given w^2 == 1/2\nclaim w^4 == 1/4\n";
const std::string split = "given a*b == 0\ngiven (a + b)*c == 0\nclaim a*c == 0\n";

void visit_branches(Branch& branch, const std::function<void(Branch&)>& action) {
    action(branch);
    for (Branch& below : branch.branches) visit_branches(below, action);
}

std::size_t number_of_branches(Certificate certificate) {
    std::size_t count = 0;
    visit_branches(certificate.root, [&](Branch&) { ++count; });
    return count;
}

}  // namespace

TEST_CASE("every proved case has a certificate that holds") {
    const auto certificates = certificates_of(
        "theorem one \"first\"\nfor n in 1..3\nmap b degree n\nclaim b(t) == b[t{n}]\nrefute b(t) == 1\n"
        "theorem two\nclaim 1 == 1 for i in 1..2\nclaim x == x\n");
    CHECK(certificates.size() == 6);
    for (const Certificate& certificate : certificates)
        CHECK(proofs::second::problem_of(certificate, {}) == "");
    const auto lines = proofs::second::confirmed_theorems(certificates, {});
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].id == "one");
    CHECK(lines[0].title == "first");
    CHECK(lines[0].confirmed);
    CHECK(lines[0].cases == 3);
    CHECK(lines[1].cases == 2);
    CHECK(lines[2].line == 1);
}

TEST_CASE("a claim is confirmed when all of its cases are, each once") {
    auto certificates = certificates_of("for n in 1..3\nclaim n*x == x*n\n");
    certificates.pop_back();
    CHECK_FALSE(proofs::second::confirmed_theorems(certificates, {}).at(0).confirmed);
    certificates.push_back(certificates.front());
    const auto again = proofs::second::confirmed_theorems(certificates, {});
    CHECK_FALSE(again.at(0).confirmed);
    CHECK(again[0].proved == 2);
    CHECK(again[0].problem == "a case has no certificate");
    CHECK(proofs::second::confirmed_theorems({}, {}).empty());
    // A certificate of a case of a false line, and one of a line `refute`.
    auto mixed = certificates_of("for n in 1..2\nclaim n == 1\n");
    REQUIRE(mixed.size() == 1);
    CHECK_FALSE(proofs::second::confirmed_theorems(mixed, {}).at(0).confirmed);
    mixed[0].which.parameters[0].second = 2;
    CHECK_FALSE(proofs::second::confirmed_theorems(mixed, {}).at(0).problem.empty());
}

TEST_CASE("another text, head or case is refused") {
    for (const std::string& text : {divided, solved, root, split}) {
        const Certificate good = certificate_of_only_case(text);
        INFO(text);
        CHECK(problem_after(good, [](Certificate& c) { c.text.insert(c.text.size() - 1, " + 1"); }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.text = "claim 1 == 2\n"; }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.text = "claim 1 == \n"; }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.text = "strict\n" + c.text; }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.text += "given 1 == 2\n"; }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.text = "theorem other\n" + c.text; }) ==
              "the text is of the theorem \"other\"");
        CHECK(problem_after(good, [](Certificate& c) { c.text = "theorem \"x\"\n" + c.text; }) != "");
        CHECK(problem_after(good, [](Certificate& c) { c.which.line = 1; }) == "the text has no such case");
        CHECK(problem_after(good, [](Certificate& c) { c.which.parameters = {{"n", 1}}; }) ==
              "the text has no such case");
    }
    // Without its hypotheses.
    CHECK(problem_after(certificate_of_only_case(solved),
                        [](Certificate& c) { c.text.replace(c.text.find("given"), 5, "#"); }) != "");
}

TEST_CASE("conditions that say too little, or nothing, are refused") {
    const Certificate good = certificate_of_only_case(divided);
    CHECK(problem_after(good, [](Certificate& c) {
              c.conditions.clear();
          }).find("the conditions do not say that") == 0);
    CHECK(problem_after(good, [](Certificate& c) { c.conditions[0].pop_back(); }) != "");
    CHECK(problem_after(good, [](Certificate& c) { c.conditions[0][0].coefficient = 7; }) != "");
    CHECK(problem_after(good, [](Certificate& c) { c.conditions.push_back({}); }) == "a condition is 0");
    CHECK(problem_after(good, [](Certificate& c) { c.conditions[0] = {{Rational(1), {}}}; }) != "");
    // A multiple of a relation is as good.
    CHECK(problem_after(good, [](Certificate& c) {
              for (auto& term : c.conditions[0]) term.coefficient *= Rational(3);
          }) == "");
}

TEST_CASE("steps that do not follow from the hypotheses are refused") {
    const Certificate good = certificate_of_only_case(solved);
    REQUIRE(good.root.steps.size() == 2);
    CHECK(problem_after(good, [](Certificate& c) { c.root.steps.clear(); }) ==
          "the two sides do not reduce to the same");
    CHECK(problem_after(good, [](Certificate& c) { c.root.steps.pop_back(); }) != "");
    for (const std::size_t i : {0U, 1U}) {
        const auto spoiled = [&](const std::function<void(proofs::second::Step&)>& spoil) {
            return problem_after(good, [&](Certificate& c) { spoil(c.root.steps[i]); });
        };
        CHECK(spoiled([](auto& step) { step.symbol = "x"; }) != "");
        CHECK(spoiled([](auto& step) { step.symbol = "nothing"; }) != "");
        CHECK(spoiled([](auto& step) { step.degree = 2; }) != "");
        CHECK(spoiled([](auto& step) { step.degree = 0; }) != "");
        CHECK(spoiled([](auto& step) { step.relation.pop_back(); }) != "");
        CHECK(spoiled([](auto& step) { step.relation.clear(); }) != "");
        CHECK(spoiled([](auto& step) { step.relation[0].coefficient += Rational(1); }) != "");
        CHECK(spoiled([](auto& step) { step.relation.push_back({Rational(1), {}}); }) != "");
        CHECK(problem_after(good, [&](Certificate& c) { c.root.steps.push_back(c.root.steps[i]); }) != "");
    }
    // The claim itself in place of a hypothesis.
    CHECK(problem_after(certificate_of_only_case("given a == b\nclaim a*c == b*c\n"),
                        [](Certificate& c) { c.text = "given a == 2*b\nclaim a*c == b*c\n"; }) != "");
    // A cofactor that may vanish: a == 0 leaves x free.
    CHECK(problem_after(certificate_of_only_case("given a*x == a\nassume a != 0\nclaim x == 1\n"),
                        [](Certificate& c) {
                            c.text = "given a*x == a\nclaim x == 1\n";
                            c.conditions.clear();
                            c.root.steps = {
                                {"x", 1, {{Rational(1), {{"a", 1}, {"x", 1}}}, {Rational(-1), {{"a", 1}}}}}};
                        }) == "step 1: the cofactor of the symbol may vanish");
    // With the condition the certificate is valid, and the condition beyond the text is reported.
    Certificate weaker = certificate_of_only_case("given a*x == a\nassume a != 0\nclaim x == 1\n");
    CHECK(proofs::second::confirmed_theorems(std::vector{weaker}, {}).at(0).where.empty());
    weaker.text = "given a*x == a\nclaim x == 1\n";
    CHECK(proofs::second::confirmed_theorems(std::vector{weaker}, {}).at(0).where ==
          std::vector<std::string>{"a != 0"});
    const Certificate power = certificate_of_only_case(root);
    CHECK(problem_after(power, [](Certificate& c) { c.root.steps[0].degree = 1; }) != "");
    CHECK(problem_after(
              power, [](Certificate& c) { c.root.steps[0].relation = {{Rational(1), {{"w", 2}}}}; }) != "");
    CHECK(problem_after(power, [](Certificate& c) {
              c.root.steps[0] = {"w", 1, {{Rational(1), {{"w", 1}}}, {Rational(-1), {}}}};
          }) != "");
}

TEST_CASE("branches that are missing, left open or wrongly ended are refused") {
    const Certificate good = certificate_of_only_case(split);
    REQUIRE(good.root.end == Branch::End::split);
    const std::size_t count = number_of_branches(good);
    CHECK(count >= 3);
    for (std::size_t place = 0; place < count; ++place) {
        const auto spoiled = [&](const std::function<void(Branch&)>& spoil) {
            return problem_after(good, [&](Certificate& c) {
                std::size_t i = 0;
                visit_branches(c.root, [&](Branch& branch) {
                    if (i++ == place) spoil(branch);
                });
            });
        };
        INFO(place);
        std::vector<Branch> all;
        Certificate copy = good;
        visit_branches(copy.root, [&](Branch& branch) { all.push_back(branch); });
        if (all[place].end == Branch::End::split) {
            CHECK(spoiled([](Branch& branch) { branch.branches.pop_back(); }) != "");
            CHECK(spoiled([](Branch& branch) { branch.branches.clear(); }) != "");
            CHECK(spoiled([](Branch& branch) { branch.branches.push_back({}); }) != "");
            CHECK(spoiled([](Branch& branch) { std::swap(branch.branches[0], branch.branches[1]); }) != "");
            CHECK(spoiled([](Branch& branch) {
                      branch.pivot = {{Rational(1), {{"c", 1}}}, {Rational(1), {}}};
                  }) != "");
            CHECK(spoiled([](Branch& branch) { branch.pivot.clear(); }) != "");
            CHECK(spoiled([](Branch& branch) { branch.end = Branch::End::agree; }) != "");
            CHECK(spoiled([](Branch& branch) {
                      branch.branches[1] = {{}, Branch::End::open, {}, {}};
                  }).find("no condition") != std::string::npos);
            CHECK(spoiled([](Branch& branch) { branch.branches[0] = {{}, Branch::End::open, {}, {}}; }) !=
                  "");
        }
        if (all[place].end == Branch::End::agree)
            CHECK(spoiled([](Branch& branch) { branch.end = Branch::End::impossible; }) != "");
        if (all[place].end == Branch::End::impossible)
            CHECK(spoiled([](Branch& branch) { branch = {{}, Branch::End::agree, {}, {}}; }) != "");
        CHECK(spoiled([](Branch& branch) { branch = {{}, Branch::End::open, {}, {}}; }) != "");
    }
    // A claim that holds in one branch only.
    CHECK(problem_after(certificate_of_only_case("given a*b == 0\nclaim a*b*c == 0\n"), [](Certificate& c) {
              c.text = "given a*b == 0\nclaim a*c == 0\n";
          }) == "branch 1: the two sides do not reduce to the same");
    // No branch in which the sides agree: nothing is proved.
    CHECK(problem_after(certificate_of_only_case("given a == 1\nclaim a == 1\n"), [](Certificate& c) {
              c.text = "given a == 1\ngiven a == 2\nclaim a == 1\n";
              c.root.end = Branch::End::impossible;
          }) != "");
}
