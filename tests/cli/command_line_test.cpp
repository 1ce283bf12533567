#include "commands/command_line.hpp"
#include "run.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include <blossom/protocol/description.hpp>
#include "json/json_text.hpp"
#include "limit_flags.hpp"
#include "operations/operation.hpp"
#include "streams/printable.hpp"

namespace {

const std::string cubic = "1 + 2t + 4t^2 - t^3";

}  // namespace

TEST_CASE("agree shows the three values") {
    const Run shown = run({"agree", cubic, "--at", "1,2,3"});
    CHECK(shown.status == 0);
    CHECK(shown.output ==
          "P(t) = 1 + 2t + 4t^2 - t^3, formal degree 3\n\n"
          "  symmetric functions   p(1, 2, 3) = 41/3\n"
          "  polarization          p(1, 2, 3) = 41/3\n"
          "  de Casteljau          p(1, 2, 3) = 41/3\n\n"
          "The three constructions agree exactly.\n");
}

TEST_CASE("agree without arguments shows the form in e1, e2, e3 and the expansion") {
    const Run shown = run({"agree", cubic});
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "p(u1, u2, u3) = 1 + 2/3 e1 + 4/3 e2 - e3\n"));
    CHECK(contains(shown.output, " - u1*u2*u3\n"));
    CHECK(contains(shown.output, "The three constructions agree exactly, for all arguments.\n"));
}

TEST_CASE("skipped constructions are named") {
    const std::vector<std::string> request{"agree", "t^3", "--at", "1,2,3", "--max-polarization-terms", "7"};
    const Run regrouped = run(request);
    CHECK(regrouped.status == 0);
    CHECK(contains(regrouped.output, "Skipped: polarization: "));
    CHECK(contains(regrouped.output, "  regrouped polarization p(1, 2, 3) = 6\n"));
    CHECK(contains(regrouped.output, "The three constructions that were run agree exactly.\n"));
    std::vector<std::string> limited = request;
    limited.insert(limited.end(), {"--max-regrouping-work", "7"});
    // Members such as "casteljau_double" are not constructions.
    std::vector<std::string> rounded = limited;
    rounded.insert(rounded.end(), {"--numbers", "double"});
    CHECK(contains(run(rounded).output, "The two constructions that were run agree exactly.\n"));
    const Run shown = run(limited);
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "Skipped: regrouped polarization: "));
    CHECK(contains(shown.output, "The two constructions that were run agree exactly.\n"));
    CHECK_FALSE(shown.output.find("three") != std::string::npos);
}

TEST_CASE("a disagreement prints what is needed to reproduce it") {
    const Json request = Json::Object{{"op", "agree"},
                                      {"map", Json::Object{{"kind", "polynomial"}, {"text", "t"}}},
                                      {"arguments", Json::Array{"5"}}};
    Answer wrong =
        Json::Object{{"agree", false},
                     {"degree", std::size_t{1}},
                     {"values", Json::Object{{"symmetric", Rational(5)}, {"casteljau", Rational(6)}}},
                     {"skipped", Json::Array{}}};
    wrong.given.push_back(read_map(*request.find("map"), Limits{}));
    const auto agree = operation_of("agree");
    const std::string text = agree->render({request, wrong, Limits{}, Style(false)});
    CHECK(contains(text, "symmetric functions   p(5) = 5\n"));
    CHECK(contains(text, "de Casteljau          p(5) = 6\n"));
    CHECK(contains(text, "DISAGREE"));
    CHECK(contains(text, R"({"op": "agree", "map": {"kind": "polynomial", "text": "t"}, "arguments": ["5"]})"
                         "\n"));
}

TEST_CASE("arguments may be points, vectors, delta and pairs") {
    CHECK(
        contains(run({"blossom", cubic, "--at", "delta,2,pair:3:2"}).output, "p(delta, 2, (3, 2)) = 14/3\n"));
    CHECK(contains(run({"blossom", cubic, "--at", "vector:1, 2, pair:3:2"}).output, "= 14/3\n"));
    CHECK(contains(run({"blossom", "t", "--at", "vector:-1/2"}).output, "p(vector -1/2) = -1/2\n"));
    CHECK(contains(run({"blossom", "5", "--at", ""}).output, "p() = 5\n"));
    CHECK(contains(run({"blossom", "t", "--at", "pair:1"}).errors, "a homogeneous argument is a pair"));
}

TEST_CASE("explain says which chapters there are, and takes statements") {
    const Run unknown = run({"explain", "roots", "t^2 - 1"});
    CHECK(unknown.status == 2);
    CHECK(contains(unknown.errors, "there is no chapter for the operation \"roots\"; there is for agree"));
    const Run proof = run({"explain", "prove", "-e", "p(t) == q[t]", "--degree", "p=1", "--degree", "q=1"});
    CHECK(proof.status == 0);
    CHECK(contains(proof.output, "p(t) ≟ q[t]"));
    CHECK(contains(proof.output, "The claim is refuted."));
    CHECK(run({"explain", "evaluate", "-t^2", "--at", "-1"}).status == 0);
}

TEST_CASE("negative numbers and polynomials are no options") {
    CHECK(contains(run({"evaluate", "-t^2", "--at", "-1/2,3"}).output, "P(-1/2) = -1/4\n"));
    CHECK(contains(run({"evaluate", "--at", "-1/2", "-t^2"}).output, "P(-1/2) = -1/4\n"));
    CHECK(contains(run({"evaluate", "-h^2", "--at=-2"}).output, "P(-2) = -4\n"));
    CHECK(contains(run({"control-points", "--control-points", "-1,0; -2,5", "--interval", "-1,1"}).output,
                   "P1 = p(1) = (-2, 5)\n"));
}

TEST_CASE("a map may be given in several ways") {
    CHECK(contains(run({"evaluate", "1 - t^2; 2t", "--at", "2"}).output, "P(2) = (-3, 4)\n"));
    CHECK(contains(run({"evaluate", "1 - t^2", "-2t", "--at", "2"}).output, "P(2) = (-3, -4)\n"));
    CHECK(contains(run({"evaluate", "1 - x^2; 2x", "--denominator", "1 + x^2", "--at", "1/2"}).output,
                   "P(x) = (1 - x^2, 2x) / (1 + x^2), formal degree 2\n\n  P(1/2) = (3/5, 4/5)\n"));
    CHECK(contains(run({"evaluate", "--control-points", "0;3;0", "--at", "1/2"}).output, "P(1/2) = 3/2\n"));
    CHECK(contains(run({"evaluate", "--control-points", "0, 3, 0", "--interval", "0,2", "--at", "1"}).output,
                   "P(1) = 3/2\n"));
    CHECK(contains(
        run({"evaluate", "--control-points", "1,0; 1,1; 0,1", "--weights", "1,1,2", "--at", "1/2"}).output,
        "P(1/2) = (3/5, 4/5)\n"));
    CHECK(contains(run({"evaluate", "--control-points", "1,1; 1,0", "--homogeneous", "--at", "1"}).output,
                   "P(1) = (1, 0)\n"));
    CHECK(contains(
        run({"evaluate", "--map", R"({"kind": "bezier", "control_points": [0, 3]})", "--at", "1/2"}).output,
        "P(1/2) = 3/2\n"));
    CHECK(contains(run({"blossom", "t", "--degree", "2", "--at", "1,2"}).output, "p(1, 2) = 3/2\n"));
    CHECK(run({"evaluate", "t", "--control-points", "0;1", "--at", "1"}).status == 2);
    CHECK(run({"evaluate", "t", "--map", "{}", "--at", "1"}).status == 2);
    CHECK(run({"evaluate", "--degree", "2", "--at", "1"}).status == 2);
}

TEST_CASE("the interval of control points is theirs, else the one that is wanted") {
    CHECK(contains(run({"control-points", cubic, "--interval", "2,-1"}).output, "P1 = p(2, 2, -1) = 7\n"));
    CHECK(contains(run({"control-points", cubic, "--over", "2,-1"}).output, "P1 = p(2, 2, -1) = 7\n"));
    const Run both = run({"control-points", "--control-points", "0;2", "--interval", "1,3", "--over", "1,2"});
    CHECK(contains(both.output, "over [1, 3]: 0, 2"));
    CHECK(contains(both.output, "P1 = p(2) = 1\n"));
    CHECK(contains(run({"control-points", "t", "--degree", "2"}).output, "P1 = p(0, 1) = 1/2\n"));
    CHECK(contains(run({"control-points", "--control-points", "0;2", "--degree", "2"}).output,
                   "P1 = p(0, 1) = 1\n"));
}

TEST_CASE("derivatives are shown as values or as a map") {
    CHECK(contains(run({"derivative", cubic, "--order", "2", "--at", "1/2,0"}).output,
                   "P''(1/2) = 5\n  P''(0) = 8\n"));
    CHECK(contains(run({"derivative", cubic}).output, "P'(t) = 2 + 8t - 3t^2\n"));
    CHECK(contains(run({"derivative", cubic, "--order", "4"}).output, "P^(4)(t) = 0\n"));
    CHECK(contains(run({"derivative", "--control-points", "0;1;4"}).output,
                   "P': control points over [0, 1]: 2, 6\n"));
}

TEST_CASE("rounded numbers are shown beside the exact ones") {
    CHECK(contains(run({"evaluate", "t/3", "--at", "1", "--numbers", "double"}).output,
                   "P(1) = 1/3 ≈ 0.3333333333333333\n"));
    CHECK(contains(run({"evaluate", "t/2", "--at", "1", "--numbers", "hexfloat"}).output,
                   "P(1) = 1/2 ≈ 0x1p-1\n"));
    CHECK(run({"evaluate", "t", "--at", "1", "--numbers", "float"}).status == 1);
}

TEST_CASE("values come from files and the standard input") {
    const auto file = std::filesystem::temp_directory_path() / "blossom-command-line-test.txt";
    std::ofstream(file) << "1 + t\r\n";
    CHECK(contains(run({"evaluate", "@" + file.string(), "--at", "1"}).output, "P(1) = 2\n"));
    CHECK(contains(run({"evaluate", "t", "--at", "-"}, "1,2\n").output, "P(2) = 2\n"));
    CHECK(contains(run({"batch", file.string()}).output, "\"syntax\""));
    CHECK(contains(run({"evaluate", "@" + file.string(), "--at", "1", "--max-line-bytes", "3"}).errors,
                   "line_bytes = 3"));
    std::filesystem::remove(file);
    CHECK(run({"evaluate", "@" + file.string(), "--at", "1"}).status == 2);
    CHECK(run({"batch", file.string()}).status == 2);
}

TEST_CASE("a syntax error has a caret below its column") {
    const Run refused = run({"evaluate", "1 + * t", "--at", "1"});
    CHECK(refused.status == 1);
    CHECK(refused.output.empty());
    CHECK(contains(refused.errors, "error: column 5: "));
    CHECK(contains(refused.errors, "\n  1 + * t\n      ^\n"));
    CHECK(contains(run({"evaluate", "t; 2 ^", "--at", "1"}).errors, "\n  2 ^\n     ^\n"));
    CHECK(contains(run({"evaluate", "--map", "{\"é\": x}", "--at", "1"}).errors,
                   "\n  {\"é\": x}\n        ^\n"));
    const Run far = run({"evaluate", std::string(500, ' ') + "*" + std::string(500, ' '), "--at", "1"});
    const std::string line(38, ' ');
    CHECK(contains(far.errors, "\n  " + line + "*"));
    CHECK(contains(far.errors, "\n  " + line + "^\n"));
}

TEST_CASE("other errors name the place and the option") {
    CHECK(contains(run({"evaluate", "t", "--at", "1,1/0"}).errors, "at --at, /at/1: \"1/0\"\n"));
    CHECK(contains(run({"blossom", "t", "--at", "1,2"}).errors, "at --at, /arguments: [\"1\", \"2\"]\n"));
    CHECK(contains(run({"evaluate", "--at", "1"}).errors, "at POLYNOMIAL, /map\n"));
    CHECK(contains(run({"evaluate", "t", "--degree", "x", "--at", "1"}).errors,
                   "at --degree, /map/degree: \"x\"\n"));
}

TEST_CASE("--json prints the response of a batch, also for an error") {
    CHECK(run({"evaluate", "t", "--at", "1/2", "--json"}).output ==
          "{\"ok\": true, \"result\": {\"values\": [\"1/2\"]}}\n");
    const Run refused = run({"evaluate", "t", "--at", "x", "--json"});
    CHECK(refused.status == 1);
    CHECK(refused.errors.empty());
    CHECK(contains(refused.output, R"({"ok": false, "error": {"code": "not_a_number", )"));
    CHECK(contains(run({"evaluate", "--map", "{", "--at", "x", "--json"}).output, R"("code": "syntax")"));
}

TEST_CASE("wrong usage has the status 2 and prints nothing on the output") {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                      {"frobnicate"},
                                                      {"evaluate", "t", "--att", "1"},
                                                      {"evaluate", "t", "--at"},
                                                      {"evaluate", "t", "--at", "1", "--at", "2"},
                                                      {"batch", "--jobs", "0"},
                                                      {"batch", "--jobs", "x"},
                                                      {"batch", "--jobs", "-1"},
                                                      {"batch", "a", "b"},
                                                      {"batch", "/nonexistent"},
                                                      {"completion", "tcsh"},
                                                      {"completion"},
                                                      {"evaluate", "t", "--at", "1", "--max-degree", "many"},
                                                      {"batch", "--max-nesting", "100000"}}) {
        CAPTURE(arguments);
        const Run refused = run(arguments);
        CHECK(refused.status == 2);
        CHECK(refused.output.empty());
        CHECK(refused.errors.starts_with("error: "));
    }
}

TEST_CASE("colours appear only where they are wanted") {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"agree", "t", "--at", "1"},
                                                      {"agree", "t"},
                                                      {"evaluate", "t", "--at", "1"},
                                                      {"blossom", "t", "--at", "1"},
                                                      {"derivative", "t"},
                                                      {"control-points", "t"},
                                                      {"evaluate", "*", "--at", "1"},
                                                      {"nothing"}}) {
        const Run plain = run(arguments);
        const Run coloured = run(arguments, "", true);
        CHECK((plain.output + plain.errors).find('\033') == std::string::npos);
        CHECK((coloured.output + coloured.errors).find("\033[") != std::string::npos);
    }
    CHECK(run({"agree", "t", "--json"}, "", true).output.find('\033') == std::string::npos);
}

TEST_CASE("every command has a summary and an example with its output") {
    const std::string help = run({"--help"}).output;
    for (const Operation& operation : operations()) {
        CAPTURE(operation.name);
        CHECK(contains(help, std::string(operation.summary)));
        const Run own = run({std::string(operation.name), "--help"});
        CHECK(own.status == 0);
        CHECK(contains(own.output, std::string(operation.documentation) + "\n"));
        CHECK(contains(own.output, "Example:\n  $ blossom " + std::string(operation.name) + " "));
        const Run example = run(operation.example);
        CHECK(example.status == 0);
        CHECK(contains(own.output, "\n  " + example.output.substr(0, example.output.find('\n'))));
    }
    CHECK(contains(run({"batch", "--help"}).output, "{\"ok\": true, \"result\": {\"values\": [\"1/4\"]}}"));
}

TEST_CASE("schema prints the JSON Schema of the protocol") {
    const Run printed = run({"schema"});
    CHECK(printed.status == 0);
    CHECK(parse_json(printed.output, Limits{}) == schema());
    CHECK(contains(printed.output, "\n    \"evaluate_request\": {\n"));
}

TEST_CASE("the version is that of the project") {
    CHECK(run({"--version"}).output == "blossom " BLOSSOM_VERSION "\n");
}

TEST_CASE("limits are flags of every command") {
    for (const LimitEntry& entry : limit_table()) {
        for (const std::string command : {"agree", "evaluate", "batch"}) {
            CHECK(contains(run({command, "--help"}).output, flag_of(entry) + " N "));
        }
    }
    CHECK(contains(run({"evaluate", "t^4", "--at", "1", "--max-degree", "3"}).errors,
                   "degree = 3 (--max-degree)"));
    CHECK(contains(run({"evaluate", "t^400", "--at", "3/7", "--max-work", "100"}).errors, "(--max-work)"));
    CHECK(contains(run({"batch", "--max-digits", "3"},
                       R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [1234]})")
                       .output,
                   "digits = 3"));
}

TEST_CASE("docs/limits.md lists the limits of the table, with flags and defaults") {
    std::ifstream file(BLOSSOM_SOURCE "/docs/limits.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::size_t rows = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| `")) ++rows;
    CHECK(rows == limit_table().size());
    for (const LimitEntry& entry : limit_table()) {
        const std::string row = "| `" + std::string(entry.name) + "` | " +
                                std::to_string(Limits{}.*entry.member) + " | `" + flag_of(entry) + "` | ";
        CAPTURE(row);
        CHECK(text.find(row) != std::string::npos);
    }
}

TEST_CASE("batch serves the standard input") {
    const std::string line = R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [5]})";
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"batch"}, {"batch", "-"}, {"batch", "--jobs", "3"}}) {
        const Run served = run(arguments, line + "\n");
        CHECK(served.status == 0);
        CHECK(served.output == "{\"ok\": true, \"result\": {\"values\": [\"5\"]}}\n");
        CHECK(run(arguments, line + "\nx\n").status == 1);
    }
}

TEST_CASE("completion scripts know every command and option") {
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        const Run script = run({"completion", shell});
        CHECK(script.status == 0);
        for (const Operation& operation : operations())
            CHECK(contains(script.output, std::string(operation.name)));
        for (const std::string word :
             {"max-degree", "control-points", "hexfloat", "casteljau", "jobs", "completion", "fish"}) {
            CHECK(contains(script.output, word));
        }
    }
}

TEST_CASE("a terminal gets whole characters and no control characters but colours") {
    CHECK(printable("a\tb\nc") == "a\tb\nc");
    CHECK(printable("\x1b[31mred\x1b[0m") == "\x1b[31mred\x1b[0m");
    CHECK(printable("\x1b[2J\x1b]0;title\x07\x7f") == "?[2J?]0;title??");
    CHECK(printable("\x1b[1;31m\x1b[") == "?[1;31m?[");
    CHECK(printable("\u03b4 \u2264 \U0001D539") == "\u03b4 \u2264 \U0001D539");
    CHECK(printable("\xff\xfe t \xc3") == "?? t ?");
    CHECK(printable("\xc0\xaf \xed\xa0\x80 \xe2\x82") == "?? ??? ??");  // too long, a surrogate, cut
    CHECK(printable("\xc2\x9b"
                    "2J") == "??2J");  // the one-byte form of ESC [
}
