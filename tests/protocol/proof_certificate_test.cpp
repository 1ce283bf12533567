#include "certificates/proof_certificate.hpp"
#include "answered.hpp"

#include <blossom/proofs/coq.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>

#include <functional>

#include "json/json_text.hpp"

namespace {

const std::string statements[] = {
    "map b degree 2\nclaim b[s, t] == (4*b((s + t)/2) - b(s) - b(t))/2\n",
    "map p degree 2\nclaim p[s, u] == (b-u)/(b-a)*p[s, a] + (u-a)/(b-a)*p[s, b]\n",
    "map a degree 3\nclaim a'(t) == 3*a[t{2}, delta]\n",
    "map f degrees 2, 1\nclaim f(u, v) == f[u, u; v]\n",
    "map q degree 2 on simplex 2\npoint r, s in 2\nclaim q(r + s) == q(r) + 2*q[r, s] + q(s)\n",
    "map f, g degree 2\ngiven f(s) == g(s)\ngiven f'(s) == g'(s)\nclaim f[x, s] == g[x, s]\n",
    "given w^2 == 1/2\nclaim w^4 == 1/4\n",
    "given a*b == 0\ngiven (a + b)*c == 0\nclaim a*c == 0\n",
};

/// The certificate as it is read from a file.
Json certificate_of(const std::string& text) {
    std::vector<proofs::second::Certificate> certificates;
    const proofs::Document document = proofs::parse(text);
    REQUIRE(document.errors.empty());
    proofs::DecisionOptions options;
    options.on_proof = [&](const proofs::ProvedCase& proved) { certificates.push_back(proved.certificate); };
    for (const auto& decision : proofs::decide(document.blocks.at(0), {}, options))
        CHECK(decision.verdict() == proofs::Verdict::proved);
    return parse_json(to_text(certificates_json(certificates)), Limits{});
}

/// Whether every claim of the certificate is confirmed in all cases; false if it cannot be read.
bool is_confirmed(const Json& certificate) {
    try {
        const auto read = read_certificates(certificate, Limits{});
        const auto lines = proofs::second::confirmed_theorems(read, Limits{});
        for (const auto& line : lines) {
            if (!line.confirmed) return false;
        }
        return !lines.empty();
    } catch (const Error&) {
        return false;
    }
}

Json& entry_of(Json& certificate) { return (*certificate["proofs"].array())[0]; }

void visit_values(Json& value, const std::function<void(Json&)>& action) {
    action(value);
    if (Json::Array* elements = value.array()) {
        for (Json& element : *elements) visit_values(element, action);
    } else if (Json::Object* members = value.object()) {
        for (auto& [name, member] : *members) visit_values(member, action);
    }
}

std::size_t values_in(Json certificate) {
    std::size_t count = 0;
    visit_values(certificate, [&](Json&) { ++count; });
    return count;
}

/// The certificate with the value at place number `place` replaced.
Json replaced(Json certificate, std::size_t place, const Json& by) {
    std::size_t count = 0;
    Json* found = nullptr;
    visit_values(certificate, [&](Json& value) {
        if (count++ == place) found = &value;
    });
    *found = by;
    return certificate;
}

/// Adds a term to each polynomial of the proof in turn: the relations of its steps and its pivots.
std::vector<Json> with_other_relations(const Json& certificate) {
    std::vector<Json> result;
    for (std::size_t place = 0;; ++place) {
        Json changed = certificate;
        std::size_t count = 0;
        bool found = false;
        visit_values(entry_of(changed)["proof"], [&](Json& value) {
            for (const char* name : {"relation", "pivot"}) {
                if (!value.object() || !value.find(name) || count++ != place) continue;
                value[name].array()->emplace_back(Json::Array{"17/3"});
                found = true;
            }
        });
        if (!found) return result;
        result.push_back(std::move(changed));
    }
}

}  // namespace

TEST_CASE("certificates of proofs are confirmed by the checker") {
    for (const std::string& text : statements) {
        INFO(text);
        CHECK(is_confirmed(certificate_of(text)));
    }
}

TEST_CASE("a certificate whose text, case, step or pivot was altered is refused") {
    for (const std::string& text : statements) {
        INFO(text);
        const Json certificate = certificate_of(text);
        const auto with = [&](std::string_view member, const Json& value) {
            Json changed = certificate;
            entry_of(changed)[member] = value;
            return changed;
        };
        CHECK_FALSE(is_confirmed(with("text", text + "claim 1 == 2\n")));
        CHECK_FALSE(is_confirmed(with("text", text + "given 1 == 2\n")));
        CHECK_FALSE(is_confirmed(with("text", text.substr(0, text.size() - 1) + " + 1\n")));
        CHECK_FALSE(is_confirmed(with("text", "claim 1 ==\n")));
        CHECK_FALSE(is_confirmed(with("text", "claim 1 == 1 for i in 1..1000000000000\n")));
        CHECK_FALSE(is_confirmed(with("line", Json::Number{"1"})));
        CHECK_FALSE(is_confirmed(with("parameters", Json::Object{{"n", Json::Number{"1"}}})));
        CHECK_FALSE(is_confirmed(with("conditions", Json::Array{Json(Json::Array{})})));
        CHECK(is_confirmed(with("id", "other")));
        CHECK_FALSE(is_confirmed([&] {
            Json changed = with("id", "other");
            entry_of(changed)["text"] = "theorem this\n" + text;
            return changed;
        }()));
        for (const Json& changed : with_other_relations(certificate)) CHECK_FALSE(is_confirmed(changed));
    }
}

TEST_CASE("a certificate that says less than its claim needs is refused") {
    Json divided = certificate_of(statements[1]);
    entry_of(divided)["conditions"] = Json::Array{};
    CHECK_FALSE(is_confirmed(divided));

    Json solved = certificate_of(statements[5]);
    entry_of(solved)["proof"]["steps"] = Json::Array{};
    CHECK_FALSE(is_confirmed(solved));

    const std::string impossible = R"({"steps": [], "end": "impossible"})";
    const std::string open = R"({"steps": [], "end": "open"})";
    const std::string agree = R"({"steps": [], "end": "agree"})";
    for (const std::string& root : {impossible, open, agree}) {
        Json changed = certificate_of(statements[7]);
        entry_of(changed)["proof"] = parse_json(root, Limits{});
        CHECK_FALSE(is_confirmed(changed));
        REQUIRE(*entry_of(changed)["proof"]["end"].text() != "split");
    }
    const Json split = certificate_of(statements[7]);
    for (const std::string& branch : {impossible, open, agree}) {
        for (const std::size_t place : {0U, 1U}) {
            Json changed = split;
            Json& proof = entry_of(changed)["proof"];
            REQUIRE(*proof["end"].text() == "split");
            (*proof["branches"].array())[place] = parse_json(branch, Limits{});
            CHECK((!is_confirmed(changed) || to_text(changed) == to_text(split)));
        }
    }
    Json shorter = split;
    entry_of(shorter)["proof"]["branches"].array()->pop_back();
    CHECK_FALSE(is_confirmed(shorter));
    Json empty = split;
    empty["proofs"] = Json::Array{};
    CHECK_FALSE(is_confirmed(empty));
}

TEST_CASE("anything in the place of anything in a certificate is read or refused") {
    const Json others[] = {Json(Json::Array{}),
                           Json(Json::Object{}),
                           Json("x"),
                           Json("1/0"),
                           Json("-1"),
                           Json::Number{"-1"},
                           Json::Number{"1.5"},
                           Json::Number{"99999999999999999999"},
                           Json()};
    for (const std::string& text : statements) {
        const Json certificate = certificate_of(text);
        const std::size_t count = values_in(certificate);
        CHECK(count > 8);
        // No replacement makes a false claim confirmed, and every error is a sentence.
        for (std::size_t place = 0; place < count; ++place) {
            for (const Json& other : others) is_confirmed(replaced(certificate, place, other));
        }
    }
}

TEST_CASE("a file that is not a certificate is refused") {
    const auto refused = [](const std::string& text) {
        try {
            read_certificates(parse_json(text, Limits{}), Limits{});
        } catch (const Error& error) {
            return pointer_of(error.place()) + " " + error.message();
        }
        return std::string();
    };
    CHECK(refused("[1]") != "");
    CHECK(refused("{}").find("certificate") != std::string::npos);
    CHECK(refused(R"({"certificate": 1, "proofs": []})") ==
          "/certificate this certificate has version 1; this program reads version 2");
    CHECK(refused(R"({"certificate": 2})").find("proofs") != std::string::npos);
    CHECK(refused(R"({"certificate": 2, "proofs": [{}]})").starts_with("/proofs/0/id "));
    CHECK(refused(R"({"certificate": 2, "proofs": [], "seal": ""})").starts_with("/seal "));
    const std::string before =
        R"({"certificate": 2, "proofs": [{"id": "", "title": "", "text": "claim 1 == 1",
        "line": 0, "parameters": {}, "conditions": [], "proof": )";
    const std::string after = "}]}";
    const std::string proof = R"({"steps": [], "end": "agree"})";
    CHECK(refused(before + proof + after) == "");
    CHECK(refused(before + R"({"steps": [], "end": "true"})" + after).starts_with("/proofs/0/proof/end "));
    CHECK(refused(before + R"({"steps": [], "end": "split"})" + after).starts_with("/proofs/0/proof/pivot "));
    CHECK(refused(before + R"({"steps": [], "end": "agree", "branches": []})" + after)
              .starts_with("/proofs/0/proof/branches "));
    CHECK(refused(before + R"({"steps": [{"symbol": "a", "degree": 1, "relation": [[]]}], "end": "agree"})" +
                  after) == "/proofs/0/proof/steps/0/relation/0 a term begins with its coefficient");
    CHECK(refused(before +
                  R"({"steps": [{"symbol": "a", "degree": 1, "relation": [["1/0"]]}], "end": "agree"})" +
                  after)
              .starts_with("/proofs/0/proof/steps/0/relation/0/0 "));
    CHECK(refused(before +
                  R"({"steps": [{"symbol": "a", "degree": 1, "relation": [["1", ["a"]]]}], "end": "agree"})" +
                  after) == "/proofs/0/proof/steps/0/relation/0/1 a power is a name and an exponent");
    CHECK(refused(before + R"({"steps": [{"symbol": "a", "degree": -1, "relation": []}], "end": "agree"})" +
                  after)
              .starts_with("/proofs/0/proof/steps/0/degree "));
    std::string deep = proof;
    for (int i = 0; i < 300; ++i)
        deep = R"({"steps": [], "end": "split", "pivot": [], "branches": [)" + deep + "," + proof + "]}";
    CHECK_THROWS_AS(parse_json(before + deep + after, Limits{}), Error);
}

TEST_CASE("proofs as lemmas of Coq") {
    const auto lemma_of = [](const std::string& text) {
        std::string lemma;
        proofs::DecisionOptions options;
        options.on_proof = [&](const proofs::ProvedCase& proved) {
            lemma = proofs::coq_lemma(proved, "example").value_or("none");
        };
        proofs::decide(proofs::parse(text).blocks.at(0), {}, options);
        return lemma;
    };
    CHECK(lemma_of("map b degree 1\nclaim b[x/(x-y)] == b(x/(x-y))") ==
          "\nLemma example : forall x_b_0 x_b_1 x_x x_y : Q, \n"
          "  ~ (x_x + (x_y * (-1 # 1))) == 0 ->\n"
          "  (1 * x_b_0 * (1) + 1 * x_b_1 * ((x_x / (x_x + (x_y * (-1 # 1))))))\n"
          "  == (x_b_0 * ((x_x / (x_x + (x_y * (-1 # 1)))))^0 + x_b_1 * "
          "((x_x / (x_x + (x_y * (-1 # 1)))))^1).\n"
          "Proof. intros; field; repeat split; assumption. Qed.\n");
    CHECK(lemma_of(statements[3]) == "none");
    CHECK(lemma_of(statements[5]) == "none");
}
