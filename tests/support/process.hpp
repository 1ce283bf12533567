#pragma once

#include <string>
#include <vector>

/// The result of a program that ran as a separate process.

struct Process {
    int status;  ///< the exit status; 128 + the number of a signal that ended it, as in a shell
    std::string output;
    std::string errors;
};

/// Runs `command` with /bin/sh in `directory`, with nothing on its standard input.
Process run_shell(const std::string& command, const std::string& directory = ".");

/// The same with a terminal as its standard output, which `output` contains.
Process run_on_terminal(const std::string& command);

/// A running program with which a test communicates line by line.
class Conversation {
public:
    explicit Conversation(const std::vector<std::string>& arguments);
    Conversation(const Conversation&) = delete;
    Conversation& operator=(const Conversation&) = delete;
    ~Conversation();

    void send(const std::string& text) const;
    /// Waits for a whole line, and returns it without its end.
    std::string receive();
    /// Closes the program's standard input and waits for its end.
    int finish();
    /// Closes the reading side of the program's standard output.
    void stop_listening();

private:
    int input_ = -1;
    int output_ = -1;
    int process_ = -1;
    std::string received_;
};
