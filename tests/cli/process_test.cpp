#include <filesystem>
#include <string>

#include "support/catch.hpp"
#include "support/process.hpp"

namespace {

const std::string program = BLOSSOM_PROGRAM;
const std::string line = R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [5]})";
const std::string answer = R"({"ok": true, "result": {"values": ["5"]}})";

std::string batch_of(const std::string& text, const std::string& options = "") {
    return "printf '%s\\n' '" + text + "' | " + program + " batch " + options;
}

}  // namespace

TEST_CASE("exit statuses of the program") {
    CHECK(run_shell(program + " evaluate t --at 1").status == 0);
    CHECK(run_shell(program + " evaluate t --at x").status == 1);
    CHECK(run_shell(program + " evaluate t --wrong").status == 2);
    CHECK(run_shell(batch_of(line)).status == 0);
    CHECK(run_shell(batch_of("x")).status == 1);
    CHECK(run_shell(program + " batch /nonexistent").status == 2);
    CHECK(run_shell(program + " batch .").status == 2);
}

TEST_CASE("nothing but responses goes to the standard output of a batch") {
    const Process served = run_shell(batch_of("x\n\n" + line));
    CHECK(served.output.substr(served.output.find('\n') + 1) == answer + "\n");
    CHECK(served.output.starts_with("{\"ok\": false"));
    CHECK(served.errors.empty());
    CHECK(run_shell(program + " batch /nonexistent").output.empty());
}

TEST_CASE("a peer that waits for each response gets it") {
    for (const std::string jobs : {"1", "2", "5"}) {
        Conversation batch({program, "batch", "--jobs", jobs});
        for (int i = 0; i < 20; ++i) {
            batch.send(line + "\n");
            CHECK(batch.receive() == answer);
        }
        // An incomplete line is not answered before its end arrives.
        batch.send(line.substr(0, 20));
        batch.send(line.substr(20) + "\n");
        CHECK(batch.receive() == answer);
        CHECK(batch.finish() == 0);
    }
}

TEST_CASE("a closed standard output ends a batch without a word") {
    for (const std::string jobs : {"1", "3"}) {
        const std::string batch = program + " batch --jobs " + jobs + "; echo $? >&2; } | head -n 1";
        const Process stopped = run_shell("{ yes '" + line + "' | " + batch);
        CHECK(stopped.output == answer + "\n");
        CHECK(stopped.errors == "141\n");
        const Process ignoring = run_shell("{ trap '' PIPE; yes '" + line + "' 2>/dev/null | " + batch);
        CHECK(ignoring.output == answer + "\n");
        CHECK(ignoring.errors == "1\n");
    }
}

TEST_CASE("a full disk is an error, not silence") {
    const Process full = run_shell(batch_of(line) + " >/dev/full");
    CHECK(full.status != 0);
    CHECK(full.errors.find("No space left") != std::string::npos);
    CHECK(run_shell(batch_of(line, "--jobs 3") + " >/dev/full").errors.find("No space left") !=
          std::string::npos);
    CHECK(run_shell(program + " evaluate t --at 1 >/dev/full").status != 0);
}

TEST_CASE("a closed output of a command is told by its status") {
    const Process closed = run_shell("{ trap '' PIPE; { sleep 0.2; " + program +
                                     " evaluate t --at 1 2>/dev/null; echo $? >&2; } | true; }");
    CHECK(closed.errors == "1\n");
}

TEST_CASE("a file is replaced when the new one is complete, and keeps its mode and its links") {
    const std::string folder = (std::filesystem::temp_directory_path() / "blossom-write-test").string();
    const std::string draw = program + " evaluate t --at 1 --svg ";
    const Process kept =
        run_shell("rm -rf " + folder + "; mkdir " + folder + " && cd " + folder +
                  " && echo old >real && chmod 640 real && ln -s real link && (ulimit -f 0; trap '' XFSZ; " +
                  draw + "link >/dev/null 2>&1); cat real && " + draw +
                  "link >/dev/null && head -c 4 real && stat -c %a real && ls");
    CHECK(kept.output == "old\n<svg640\nlink\nreal\n");
    CHECK(run_shell(draw + folder + "/none/file.svg").status == 2);
    std::filesystem::remove_all(folder);
}

TEST_CASE("colours are for terminals that want them") {
    const auto coloured = [](const std::string& environment) {
        return run_on_terminal("env -u NO_COLOR " + environment + " " + program + " agree t --at 1")
                   .output.find("\033[") != std::string::npos;
    };
    CHECK(coloured("TERM=xterm"));
    CHECK_FALSE(coloured("TERM=xterm NO_COLOR=1"));
    CHECK(coloured("TERM=xterm NO_COLOR="));
    CHECK_FALSE(coloured("TERM=dumb"));
    CHECK_FALSE(coloured("-u TERM"));
    CHECK(run_shell("TERM=xterm " + program + " agree t --at 1").output.find('\033') == std::string::npos);
}

TEST_CASE("bash completes commands, options and values") {
    const auto completed = [](const std::string& words, int index) {
        const std::string script =
            "source <(" + program + " completion bash); COMP_WORDS=(" + words +
            "); COMP_CWORD=" + std::to_string(index) +
            "; complete -p blossom >/dev/null && _blossom; printf '%s ' ${COMPREPLY[@]+\"${COMPREPLY[@]}\"}";
        const Process bash = run_shell("bash -eu <<'END'\n" + script + "\nEND");
        CHECK(bash.errors.empty());
        CHECK(bash.status == 0);
        return bash.output;
    };
    CHECK(run_shell(program + " completion bash | bash -n").status == 0);
    CHECK(completed("blossom ag", 1) == "agree ");
    CHECK(completed("blossom --v", 1) == "--version ");
    CHECK(completed("blossom agree --nu", 2) == "--numbers ");
    CHECK(completed("blossom agree --numbers \"\"", 3) == "double hexfloat ");
    CHECK(completed("blossom blossom --construction c", 3) == "casteljau ");
    CHECK(completed("blossom completion z", 2) == "zsh ");
    CHECK(completed("blossom agree --at --", 3) == " ");
}
