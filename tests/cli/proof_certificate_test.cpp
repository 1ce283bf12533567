#include "proof_certificate.hpp"

#include <blossom/proofs/coq.hpp>
#include <blossom/proofs/parser.hpp>

#include <functional>
#include <string>

#include "json_text.hpp"
#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::cli;

namespace {

const std::string statements[] = {
    "map b degree 2\nclaim b[s, t] == (4*b((s + t)/2) - b(s) - b(t))/2",
    "map p degree 2\nclaim p[s, u] == (b-u)/(b-a)*p[s, a] + (u-a)/(b-a)*p[s, b]",
    "map a degree 3\nclaim a'(t) == 3*a[t{2}, delta]",
    "map f degrees 2, 1\nclaim f(u, v) == f[u, u; v]",
    "map q degree 2 on simplex 2\npoint r, s in 2\nclaim q(r + s) == q(r) + 2*q[r, s] + q(s)",
    "map f, g degree 2\ngiven f(s) == g(s)\ngiven f'(s) == g'(s)\nclaim f[x, s] == g[x, s]",
};

Json certificate_of(const std::string& text) {
    Json::Array entries;
    const proofs::Document document = proofs::parse(text);
    REQUIRE(document.errors.empty());
    const auto decisions = proofs::decide(document.blocks.at(0), {}, [&](const proofs::ProvedCase& proved) {
        entries.push_back(certificate_entry(proved, "test", text));
    });
    for (const auto& decision : decisions) CHECK(decision.verdict == proofs::Verdict::proved);
    // As it is read back from a file.
    return parse_json(to_text(sealed_certificate(std::move(entries))), Limits{});
}

void resealed(Json& certificate) { certificate["seal"] = seal_of(*certificate.find("proofs")); }

bool is_number(const Json& value) {
    return value.number() ||
           (value.text() && value.text()->find_first_not_of("-0123456789/") == std::string::npos);
}

void visit_numbers(Json& value, const std::function<void(Json&)>& action) {
    if (Json::Array* elements = value.array()) {
        for (Json& element : *elements) visit_numbers(element, action);
    } else if (Json::Object* members = value.object()) {
        for (auto& [name, member] : *members) visit_numbers(member, action);
    } else if (is_number(value)) {
        action(value);
    }
}

/// The certificate with number `place` of the members of its first proof increased by 1.
Json altered(Json certificate, std::initializer_list<std::string_view> members, std::size_t place) {
    Json& entry = certificate.find("proofs") ? (*certificate["proofs"].array())[0] : certificate;
    std::size_t count = 0;
    for (const std::string_view member : members) {
        visit_numbers(entry[member], [&](Json& number) {
            if (count++ != place) return;
            if (number.number()) {
                number = Json::Number{std::to_string(std::stoul(number.number()->text) + 1)};
            } else {
                number = *number.text() == "1" ? "2" : "1";
            }
        });
    }
    return certificate;
}

std::size_t numbers_in(Json certificate, std::initializer_list<std::string_view> members) {
    std::size_t count = 0;
    for (const std::string_view member : members) {
        visit_numbers((*certificate["proofs"].array())[0][member], [&](Json&) { ++count; });
    }
    return count;
}

}  // namespace

TEST_CASE("certificates of proofs are confirmed by the checker") {
    for (const std::string& text : statements) {
        INFO(text);
        const CertificateCheck check = check_certificate(certificate_of(text));
        CHECK(check.confirmed == 1);
        CHECK(check.problems.empty());
    }
}

TEST_CASE("a certificate with one altered number is rejected") {
    for (const std::string& text : statements) {
        INFO(text);
        const Json certificate = certificate_of(text);
        const auto everywhere = {std::string_view("parameters"), std::string_view("maps"),
                                 std::string_view("nodes"),      std::string_view("left"),
                                 std::string_view("right"),      std::string_view("numerator"),
                                 std::string_view("denominator")};
        const std::size_t count = numbers_in(certificate, everywhere);
        CHECK(count > 10);
        for (std::size_t place = 0; place < count; ++place) {
            CHECK_FALSE(check_certificate(altered(certificate, everywhere, place)).problems.empty());
        }
        // With a new seal it is the mathematics that does not fit.
        const auto form = {std::string_view("numerator"), std::string_view("denominator")};
        for (std::size_t place = 0; place < numbers_in(certificate, form); ++place) {
            Json changed = altered(certificate, form, place);
            resealed(changed);
            CHECK_FALSE(check_certificate(changed).problems.empty());
        }
    }
}

TEST_CASE("a record of something false is rejected whatever it claims") {
    Json certificate = certificate_of(statements[0]);
    Json& entry = (*certificate["proofs"].array())[0];
    std::size_t rejected = 0;
    std::size_t altered_constants = 0;
    for (Json& node : *entry["nodes"].array()) {
        Json& value = (*node.array())[1];
        if (*(*node.array())[0].text() != "constant") continue;
        const Json before = value;
        value = "5/3";
        resealed(certificate);
        ++altered_constants;
        if (!check_certificate(certificate).problems.empty()) ++rejected;
        value = before;
    }
    // The mass of a point is a constant too.
    CHECK(altered_constants >= 4);
    CHECK(rejected == altered_constants);
    entry["right"] = *entry.find("left");
    resealed(certificate);
    CHECK(check_certificate(certificate).problems.empty());
}

TEST_CASE("what is no certificate is refused") {
    const auto problem = [](const std::string& text) {
        const CertificateCheck check = check_certificate(parse_json(text, Limits{}));
        return check.problems.empty() ? "" : check.problems.back();
    };
    CHECK_THROWS_AS(problem("{}"), Error);
    CHECK_THROWS_AS(problem("[1]"), Error);
    CHECK(problem(R"({"seal": "", "proofs": [{}]})").find("no \"symbols\"") != std::string::npos);
    CHECK(problem(R"({"seal": "", "proofs": [{"symbols": [], "maps": [], "nodes": [["sum", 0]]}]})")
              .find("not below") != std::string::npos);
    CHECK(problem(R"({"seal": "", "proofs": [{"symbols": [], "maps": [], "nodes": [["constant", "1/0"]]}]})")
              .find("zero denominator") != std::string::npos);
}

TEST_CASE("proofs as lemmas of Coq") {
    const auto lemma_of = [](const std::string& text) {
        std::string lemma;
        proofs::decide(proofs::parse(text).blocks.at(0), {}, [&](const proofs::ProvedCase& proved) {
            lemma = proofs::coq_lemma(proved, "example").value_or("none");
        });
        return lemma;
    };
    CHECK(lemma_of("map b degree 1\nclaim b[x/(x-y)] == b(x/(x-y))") ==
          "\nLemma example : forall x_b_0 x_b_1 x_x x_y : Q, \n"
          "  ~ (x_x + (x_y * (-1 # 1))) == 0 ->\n"
          "  (1 * x_b_0 * (1) + 1 * x_b_1 * ((x_x / (x_x + (x_y * (-1 # 1))))))\n"
          "  == (1 * x_b_0 * ((x_x / (x_x + (x_y * (-1 # 1)))))^0 + 1 * x_b_1 * "
          "((x_x / (x_x + (x_y * (-1 # 1)))))^1).\n"
          "Proof. intros; field; repeat split; assumption. Qed.\n");
    CHECK(lemma_of(statements[3]) == "none");
    CHECK(lemma_of(statements[5]) == "none");
}
