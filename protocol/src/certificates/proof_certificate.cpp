#include "proof_certificate.hpp"

#include <array>
#include <string_view>

#include "json/fields.hpp"

namespace blossom::protocol {

namespace second = proofs::second;

namespace {

constexpr std::size_t version = 2;
constexpr std::array<std::string_view, 4> end_names{"agree", "impossible", "split", "open"};

/// [["3/2", ["t_1", 2], ...], ...]
Json polynomial_json(const second::NamedPolynomial& polynomial) {
    Json::Array terms;
    for (const second::NamedTerm& term : polynomial) {
        Json::Array parts{term.coefficient};
        for (const auto& [name, exponent] : term.powers) parts.emplace_back(Json::Array{name, exponent});
        terms.emplace_back(std::move(parts));
    }
    return terms;
}

/// {"steps": [{"symbol", "degree", "relation"}], "end", "pivot"?, "branches"?}
Json branch_json(const second::Branch& branch) {
    Json::Array steps;
    for (const second::Step& step : branch.steps) {
        steps.emplace_back(Json::Object{
            {"symbol", step.symbol}, {"degree", step.degree}, {"relation", polynomial_json(step.relation)}});
    }
    Json result =
        Json::Object{{"steps", std::move(steps)}, {"end", end_names[static_cast<std::size_t>(branch.end)]}};
    if (branch.end != second::Branch::End::split) return result;
    Json::Array branches;
    for (const second::Branch& below : branch.branches) branches.emplace_back(branch_json(below));
    result["pivot"] = polynomial_json(branch.pivot);
    result["branches"] = std::move(branches);
    return result;
}

Json certificate_json(const second::Certificate& certificate) {
    Json::Array conditions;
    for (const second::NamedPolynomial& condition : certificate.conditions)
        conditions.emplace_back(polynomial_json(condition));
    return Json::Object{{"id", certificate.id},
                        {"title", certificate.title},
                        {"text", certificate.text},
                        {"line", certificate.which.line},
                        {"parameters", parameters_json(certificate.which.parameters)},
                        {"conditions", std::move(conditions)},
                        {"proof", branch_json(certificate.root)}};
}

/// Reads the parts of a certificate, which may be anything.
class CertificateReader {
public:
    explicit CertificateReader(const Limits& limits) : limits_(limits) {}

    second::Certificate certificate(const Json& json) const {
        Fields fields(json);
        second::Certificate result;
        result.id = fields.required("id", read_text);
        result.title = fields.required("title", read_text);
        result.text = fields.required("text", read_text);
        result.which.line =
            fields.required("line", [&](const Json& line) { return read_index(line, limits_); });
        result.which.parameters =
            fields.required("parameters", [&](const Json& list) { return parameters(list); });
        result.conditions = fields.required("conditions", [&](const Json& list) {
            return read_list(list, [&](const Json& one) { return polynomial(one); });
        });
        result.root = fields.required("proof", [&](const Json& root) { return branch(root); });
        fields.finish();
        return result;
    }

private:
    std::vector<std::pair<std::string, long long>> parameters(const Json& json) const {
        if (!json.object()) throw Error(ErrorCode::wrong_kind, "the parameters are an object of integers");
        std::vector<std::pair<std::string, long long>> list;
        for (const auto& [name, value] : *json.object()) {
            const Rational number = within(name, [&] { return read_number(value, limits_); });
            const auto word = number.is_integer() ? number.numerator().to_int64() : std::nullopt;
            if (!word)
                throw Error(ErrorCode::wrong_kind, "a parameter is an integer of 64 bits", Place{name});
            list.emplace_back(name, *word);
        }
        return list;
    }

    second::NamedPolynomial polynomial(const Json& json) const {
        return read_list(json, [&](const Json& term) {
            const Json::Array& parts = read_array(term);
            if (parts.empty()) throw Error(ErrorCode::wrong_arity, "a term begins with its coefficient");
            second::NamedTerm result{within(std::size_t{0}, [&] { return read_number(parts[0], limits_); }),
                                     {}};
            for (std::size_t i = 1; i < parts.size(); ++i)
                result.powers.push_back(within(i, [&] { return power(parts[i]); }));
            return result;
        });
    }

    std::pair<std::string, std::size_t> power(const Json& json) const {
        const Json::Array& parts = read_array(json);
        if (parts.size() != 2) throw Error(ErrorCode::wrong_arity, "a power is a name and an exponent");
        return {within(std::size_t{0}, [&] { return read_text(parts[0]); }),
                within(std::size_t{1}, [&] { return read_count(parts[1], limits_); })};
    }

    second::Step step(const Json& json) const {
        Fields fields(json);
        second::Step result;
        result.symbol = fields.required("symbol", read_text);
        result.degree =
            fields.required("degree", [&](const Json& degree) { return read_count(degree, limits_); });
        result.relation = fields.required("relation", [&](const Json& one) { return polynomial(one); });
        fields.finish();
        return result;
    }

    second::Branch branch(const Json& json) const {
        Fields fields(json);
        second::Branch result;
        result.steps = fields.required("steps", [&](const Json& steps) {
            return read_list(steps, [&](const Json& one) { return step(one); });
        });
        result.end = static_cast<second::Branch::End>(fields.required(
            "end", [&](const Json& end) { return read_alternative(end, end_names, "an end of a branch"); }));
        if (result.end == second::Branch::End::split) {
            result.pivot = fields.required("pivot", [&](const Json& pivot) { return polynomial(pivot); });
            result.branches = fields.required("branches", [&](const Json& branches) {
                return read_list(branches, [&](const Json& one) { return branch(one); });
            });
        }
        fields.finish();
        return result;
    }

    const Limits& limits_;
};

}  // namespace

Json parameters_json(const proofs::Parameters& parameters) {
    Json::Object result;
    for (const auto& [name, value] : parameters)
        result.emplace_back(name, Json::Number{std::to_string(value)});
    return result;
}

Json certificates_json(std::span<const second::Certificate> certificates) {
    Json::Array proofs;
    for (const second::Certificate& certificate : certificates)
        proofs.emplace_back(certificate_json(certificate));
    return Json::Object{{"certificate", version}, {"proofs", std::move(proofs)}};
}

std::vector<second::Certificate> read_certificates(const Json& json, const Limits& limits) {
    Fields fields(json);
    const std::size_t written =
        fields.required("certificate", [&](const Json& number) { return read_count(number, limits); });
    if (written != version) {
        throw Error(ErrorCode::wrong_kind,
                    "this certificate has version " + std::to_string(written) +
                        "; this program reads version " + std::to_string(version),
                    Place{"certificate"});
    }
    const CertificateReader reader(limits);
    std::vector<second::Certificate> certificates = fields.required("proofs", [&](const Json& proofs) {
        return read_list(proofs, [&](const Json& one) { return reader.certificate(one); });
    });
    fields.finish();
    return certificates;
}

}  // namespace blossom::protocol
