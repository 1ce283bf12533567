#include <blossom/protocol/description.hpp>
#include "answered.hpp"
#include "maps/kind.hpp"
#include "operations/map_options.hpp"

// The descriptions of operations and kinds of maps, compared with their behaviour for the golden requests and
// those of docs/protocol.md.

namespace {

using Names = std::set<std::string, std::less<>>;

Names names_of(const FieldList& fields) {
    Names names;
    for (const Field& field : fields) names.emplace(field.name);
    return names;
}

/// The names in the first list that are not in the second, "a, b".
std::string missing_text(const Names& names, const Names& others) {
    std::string text;
    for (const std::string& name : names) {
        if (!others.contains(name)) text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

std::vector<Json> example_requests() {
    std::vector<Json> requests;
    std::ifstream golden(BLOSSOM_SOURCE "/tests/golden/protocol-examples.jsonl");
    for (std::string line; std::getline(golden, line);)
        requests.push_back(*parse_json(line, Limits{}).find("request"));
    std::ifstream page(BLOSSOM_SOURCE "/docs/protocol.md");
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) inside = line == "```jsonl";
        if (inside && line.find("\"op\"") != std::string::npos)
            requests.push_back(parse_json(line, Limits{}));
    }
    return requests;
}

/// The fields and members that one operation or kind of map used.
struct Observed {
    Names asked;    ///< fields that were looked up
    Names read;     ///< those of them that were present
    Names written;  ///< members of results
};

void add_read(Observed& observed, const Fields& fields, const Json& object) {
    for (const std::string_view name : fields.asked()) {
        observed.asked.emplace(name);
        if (object.find(name)) observed.read.emplace(name);
    }
}

void add_written(Observed& observed, const Json& object) {
    for (const auto& [name, member] : *object.object()) observed.written.insert(name);
}

/// Observes the operations and kinds of all requests and maps in a request.
class Observation {
public:
    void add(const Json& value) {
        if (const Json::Array* elements = value.array()) {
            for (const Json& element : *elements) add(element);
        }
        const Json::Object* members = value.object();
        if (!members) return;
        for (const auto& [name, member] : *members) add(member);
        if (value.find("op")) add_request(value);
        if (value.find("kind")) add_map(value);
    }

    std::map<std::string, Observed> operations;
    std::map<std::string, Observed> kinds;

private:
    void add_request(const Json& request) {
        const std::string* name = request.find("op")->text();
        const Operation* const found = name ? operation_of(*name) : nullptr;
        if (!found) return;
        Json::Object own = *request.object();
        std::erase_if(own, [](const Json::Member& member) {
            return member.first == "op" || names_of(common_fields()).contains(member.first);
        });
        const Json without_common = std::move(own);
        Observed& observed = operations[std::string(found->name)];
        Request fields(without_common);
        try {
            add_written(observed, found->answer(fields, Limits{}).result);
        } catch (const Error&) {
            static_cast<void>(fields);  // the fields that were read before the error count
        }
        add_read(observed, fields, without_common);
    }
    void add_map(const Json& map) {
        Fields fields(map);
        try {
            const KindWord& word = word_of(fields, *map.find("kind"));
            Observed& observed = kinds[title_of(word, " with ")];
            try {
                add_written(observed, to_json(word.read(fields, Limits{})));
            } catch (const Error&) {
                static_cast<void>(fields);
            }
            add_read(observed, fields, map);
        } catch (const Error&) {
            return;  // an unknown kind
        }
    }
};

const Observation& observation() {
    static const Observation all = [] {
        Observation observed;
        for (const Json& request : example_requests()) observed.add(request);
        return observed;
    }();
    return all;
}

const Observed& observed_in(const std::map<std::string, Observed>& all, const std::string& name) {
    static const Observed nothing;
    const auto found = all.find(name);
    return found == all.end() ? nothing : found->second;
}

}  // namespace

TEST_CASE("an operation reads the fields that it declares, and no others") {
    for (const Operation& operation : operations()) {
        CAPTURE(std::string(operation.name));
        const Observed& observed = observed_in(observation().operations, std::string(operation.name));
        const Names declared = names_of(all_fields(operation.request));
        Names known = names_of(common_fields());
        known.insert(declared.begin(), declared.end());
        CHECK(missing_text(observed.asked, known) == "");
        CHECK(missing_text(declared, observed.read) == "");
    }
}

TEST_CASE("a result has the members that its operation declares, and no others") {
    for (const Operation& operation : operations()) {
        CAPTURE(std::string(operation.name));
        const Observed& observed = observed_in(observation().operations, std::string(operation.name));
        Names declared = names_of(all_fields(operation.result));
        CHECK(missing_text(observed.written, declared) == "");
        // Constructions have expansions only if they disagree, which is an internal error.
        if (operation.name == "agree") declared.erase("expansions");
        CHECK(missing_text(declared, observed.written) == "");
    }
}

TEST_CASE("a kind of map reads and writes the fields that it declares, and no others") {
    for (const Kind* kind : Kinds::all) {
        for (const KindWord& word : words_of(*kind)) {
            const std::string title = title_of(word, " with ");
            CAPTURE(title);
            const Observed& observed = observed_in(observation().kinds, title);
            Names declared = names_of(all_fields(word.members()));
            CHECK(missing_text(observed.asked, declared) == "");
            CHECK(missing_text(declared, observed.read) == "");
            declared.insert("kind");
            CHECK(missing_text(observed.written, declared) == "");
        }
    }
}

TEST_CASE("every operation, field and option is documented") {
    for (const OperationDescription& operation : operation_descriptions()) {
        CAPTURE(operation.name);
        CHECK(operation.documentation.ends_with('.'));
        for (const auto* fields : {&operation.fields, &operation.result}) {
            for (const FieldDescription& field : *fields) {
                CAPTURE(field.name);
                CHECK_FALSE(field.kind.empty());
                CHECK_FALSE(field.documentation.empty());
            }
        }
    }
    for (const Operation& operation : operations()) {
        for (const Option& option : operation.options) {
            CAPTURE(std::string(operation.name), option.name);
            CHECK_FALSE(option.help.empty());
        }
    }
}

TEST_CASE("the alternatives of a field are those of its option") {
    const Operation* const insert_knots = operation_of("insert-knots");
    const auto method = std::ranges::find(insert_knots->options, std::string("--method"), &Option::name);
    CHECK(method->value == "boehm|oslo");
    const auto& described = operation_descriptions();
    const auto convert = std::ranges::find(described, std::string("convert"), &OperationDescription::name);
    const auto to = std::ranges::find(convert->fields, std::string("to"), &FieldDescription::name);
    CHECK(to->required);
    CHECK(std::ranges::count(to->alternatives, std::string_view("hermite")) == 1);
    CHECK(std::ranges::count(to->alternatives, std::string_view("simplex")) == 1);
}

TEST_CASE("a field says when it must be there") {
    const auto field = [](std::string_view name) { return required(name, ValueKind::text, ""); };
    const Members members{
        {field("always"), optional("never", ValueKind::text, "")},
        {{{field("map"), field("at")}, {field("maps"), optional("at", ValueKind::text, "")}},
         {{field("computed")},
          {field("computed"), field("parameters")},
          {field("format"), field("document")}}}};
    for (const auto& [name, presence] :
         std::vector<std::pair<std::string_view, std::string_view>>{{"always", "yes"},
                                                                    {"never", "no"},
                                                                    {"map", "or `maps`"},
                                                                    {"at", "with `map`"},
                                                                    {"computed", "or `format`"},
                                                                    {"parameters", "no"},
                                                                    {"document", "or `computed`"}}) {
        CHECK(presence_text(members, name) == presence);
    }
}
