#include <iterator>
#include "run.hpp"

namespace {

/// A temporary folder that is removed with the object.
class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / "blossom-prove-records") {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    Folder(Folder&&) = delete;
    Folder& operator=(Folder&&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    std::string at(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(at(name)) << text;
        return at(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream file(at(name));
        REQUIRE(file);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool has(const std::string& name) const { return std::filesystem::exists(at(name)); }

private:
    std::filesystem::path path_;
};

const std::string two_theorems =
    "theorem one \"first\"\n"
    "map b degree 1\n"
    "claim b(t) == b[t]\n"
    "theorem one \"second\"\n"
    "claim x == y\n";

const std::string first_fragment = R"(% theorem one
{\emergencystretch=3em\noindent
\textbf{first.}
Let $b$ be a polynomial of formal degree $1$.
Then
\[
  b(t) = b[t].
\]
\emph{Proved.}
\par}
% end of theorem one
)";

const std::string second_fragment = R"(% theorem one-2
{\emergencystretch=3em\noindent
\textbf{second.}
The claim is that
\[
  x = y.
\]
\emph{Refuted.}
For $x = 0$ and $y = 1$ the left side is $0$ and the right side $1$.
\par}
% end of theorem one-2
)";

}  // namespace

TEST_CASE("a text without claims is an error of prove, and none where it is only formatted") {
    const Run proof = run({"prove", "-"}, "number x\n");
    CHECK(proof.status == 2);
    CHECK(contains(proof.errors, "there is nothing to decide"));
    CHECK(run({"prove", "--format", "-"}, "number x\n").status == 0);
}

TEST_CASE("theorems in LaTeX are written to one file, or to one file each") {
    const Folder folder;
    const std::string file = folder.write("two.blossom", two_theorems);
    CHECK(run({"prove", file, "--latex", folder.at("all.tex")}).status == 1);
    CHECK(folder.read("all.tex") == first_fragment + "\n" + second_fragment);
    run({"prove", file, "--latex", folder.at("new/folder/")});
    CHECK(folder.read("new/folder/one.tex") == first_fragment);
    CHECK(folder.read("new/folder/one-2.tex") == second_fragment);
    run({"prove", "-e", "x == x", "--latex", folder.at("new")});
    CHECK(contains(folder.read("new/statement.tex"), "\\emph{Proved.}"));
    CHECK(run({"prove", file, "--latex", folder.at("two.blossom/x.tex")}).status == 2);
}

TEST_CASE("a report for JUnit counts what is not as expected") {
    const Folder folder;
    const std::string text = two_theorems + "claim 1/0 == x\nrefute x == y\ntheorem three\nclaim x = y < z\n";
    const std::string input = text;
    CHECK(run({"prove", "-", "--junit", folder.at("report.xml")}, input).status == 2);
    CHECK(folder.read("report.xml") == R"(<?xml version="1.0"?>
<testsuites name="blossom prove">
  <testsuite name="standard input" tests="5" failures="1" errors="2">
    <testcase classname="standard input" name="line 9">
      <error message="not read">standard input:9:9: "=" found, expected "==" between the two sides
  claim x = y &lt; z
          ^
</error>
    </testcase>
    <testcase classname="standard input" name="one, line 3" />
    <testcase classname="standard input" name="one, line 5">
      <failure message="refuted">refuted   one  (expected: proved)
    x = 0, y = 1
    left side 0, right side 1
</failure>
    </testcase>
    <testcase classname="standard input" name="one, line 6">
      <error message="undecided">undecided one
standard input:6:9: the denominator is zero
  claim 1/0 == x
          ^
</error>
    </testcase>
    <testcase classname="standard input" name="one, line 7" />
  </testsuite>
</testsuites>
)");
}

TEST_CASE("explain shows every claim of files and statements, in general first") {
    const Folder folder;
    const std::string file = folder.write("two.blossom", two_theorems);
    const Run pages = run({"explain", "prove", file, "-e", "p(t) == q[t]", "--degree", "p=1", "--degree",
                           "q=1", "--columns", "120"});
    CHECK(pages.status == 0);
    CHECK(contains(pages.output, "A proof: first\n==="));
    CHECK(contains(pages.output, "A refutation: second\n==="));
    CHECK(contains(pages.output,
                   "Let p be a polynomial of formal degree 1. Let q be a polynomial of formal degree 1."));
    const Run general =
        run({"explain", "prove", "-e", "for n in 1..2\nmap a degree n\nclaim a(t) == a[t{n}]"});
    CHECK(contains(general.output,
                   "  a(t) ≟ a[t^<n>]\n\nfor n = 1, 2.\n\nThe statement in the identity language."));
    CHECK(contains(general.output, "Here, for n = 2 this is, written out:\n\n  a(t) ≟ a[t, t]"));
    CHECK(contains(run({"explain", "prove", "-", "--format", "html"}, two_theorems).output,
                   "<h1>A refutation: second</h1>"));
    CHECK(contains(run({"explain", "prove", file, "--format", "json"}).output, "\n},\n{\n"));
    CHECK(run({"explain", "prove", folder.at("none.blossom")}).status == 2);
    const Run wrong = run({"explain", "prove", "-e", "x ==", "-e", "y == y"});
    CHECK(wrong.status == 1);
    CHECK(contains(wrong.errors, "line 1, column 11"));
}
