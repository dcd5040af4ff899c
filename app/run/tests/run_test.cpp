// `raylab run` as a person and as a program meet it.
#include "app/run/compiler_errors.h"
#include "app/run/host_code.h"
#include "app/run/output.h"
#include "app/tests/shell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace raylab::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string corpus = RAYLAB_ROOT "/tests/machine/cuda/";

Outcome run(const std::string& arguments) {
    return run_in_shell(std::string(RAYLAB_RUN_PROGRAM) + " run " + arguments);
}

TEST(Run, WrongUsageIsRefused) {
    EXPECT_EQ(run("").code, 2);
    EXPECT_EQ(run("nowhere.cu").code, 2);
    EXPECT_THAT(run("nowhere.cu").text, HasSubstr("no file or folder 'nowhere.cu'"));
    EXPECT_EQ(run(RAYLAB_ROOT "/README.md").code, 2);
    EXPECT_EQ(run(RAYLAB_ROOT "/docs").code, 2);
    EXPECT_EQ(run(corpus + "n02_histogram.cu --machine fast").code, 2);
    EXPECT_EQ(run(corpus + "n02_histogram.cu --json --sarif").code, 2);
}

TEST(Run, ARightProgramIsToldSo) {
    const Outcome outcome = run(corpus + "n02_histogram.cu");
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("nothing found"));
    EXPECT_THAT(outcome.text, HasSubstr("1 launch"));
}

TEST(Run, AMistakeHasItsLineThreadAndAdvice) {
    const Outcome outcome = run(corpus + "w49_null_pointer.cu");
    EXPECT_EQ(outcome.code, 1) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("w49_null_pointer.cu:6:62: error: null pointer"));
    EXPECT_THAT(outcome.text, HasSubstr("kernel k, block (0,0,0), thread (0,0,0)"));
    EXPECT_THAT(outcome.text, HasSubstr("to mend it: allocate"));
}

TEST(Run, TheDebuggerStopsInAKernel) {
    if (run_in_shell("gdb --version").code != 0) GTEST_SKIP() << "gdb is not installed";
    const fs::path commands = fs::path(testing::TempDir()) / "raylab_gdb_commands";
    std::ofstream(commands) << "tbreak k if $threadIdx(\"x\") == 9 && $blockIdx() == 1\n"
                               "continue\nprint blockDim.x\nprint $gridDim(\"x\")\n";
    const Outcome outcome = run(corpus + "n02_histogram.cu --gdb -- word < " + commands.string());
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("n02_histogram.cu:8\n8\t    if (threadIdx.x < 8)"));
    EXPECT_THAT(outcome.text, HasSubstr("$1 = 64\n"));
    EXPECT_THAT(outcome.text, HasSubstr("$2 = 2\n"));
    fs::remove(commands);
}

TEST(Run, ForPrograms) {
    EXPECT_THAT(run(corpus + "w49_null_pointer.cu --json 2>/dev/null").text,
                HasSubstr("\"kind\": \"null-pointer\""));
    EXPECT_THAT(run(corpus + "w49_null_pointer.cu --github 2>/dev/null").text,
                HasSubstr("::error file=" + corpus + "w49_null_pointer.cu,line=6,col=62"));
    EXPECT_THAT(run(corpus + "w49_null_pointer.cu --sarif 2>/dev/null").text,
                HasSubstr("\"startLine\": 6"));
}

// The row of a table of --machine memory that ends with a line of patterns.cu, its columns in
// order.
std::vector<std::string> row_of(const std::string& table, int line, const std::string& access) {
    std::istringstream lines(table);
    const std::string end = fmt::format("patterns.cu:{}:", line);
    for (std::string row; std::getline(lines, row);) {
        if (row.find(end) == row.npos || row.find(access) == row.npos) continue;
        std::istringstream words(row);
        return {std::istream_iterator<std::string>(words), {}};
    }
    return {};
}

TEST(Run, WhatAccessesCost) {
    const std::string table =
        run(RAYLAB_ROOT "/tests/machine/memory/patterns.cu --machine memory").text;
    using testing::_;
    using testing::ElementsAre;
    // memory, access, requests, threads a warp, sectors a request, (least), line
    EXPECT_THAT(row_of(table, 5, "read"),
                ElementsAre("global", "read", "2", "32.0", "4.0", "(", "4.0)", _))
        << table;
    EXPECT_THAT(row_of(table, 9, "read"),
                ElementsAre("global", "read", "1", "32.0", "32.0", "(", "4.0)", _));
    EXPECT_THAT(row_of(table, 19, "write"),
                ElementsAre("global", "write", "1", "16.0", "2.0", "(", "2.0)", _));
    // memory, access, requests, threads a warp, bank conflicts, line
    EXPECT_THAT(row_of(table, 13, "write"), ElementsAre("shared", "write", "1", "32.0", "31", _));

    const std::string json =
        run(RAYLAB_ROOT "/tests/machine/memory/patterns.cu --machine memory --json 2>/dev/null")
            .text;
    EXPECT_THAT(json, HasSubstr("\"bank_conflicts\": 31"));
    EXPECT_THAT(json, HasSubstr("\"sectors_per_request\": 32.0"));
}

TEST(Run, WhatDoesNotCompile) {
    const fs::path file = fs::temp_directory_path() / "raylab_run_test.cu";
    std::ofstream(file) << "int main() { return x; }\n";
    const Outcome outcome = run(file.string());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("raylab_run_test.cu:1:21: error:"));
    std::ofstream(file) << "int main(int n, char** words) { return n == 2 && *words[1] == 'a'; }\n";
    EXPECT_EQ(run(file.string()).code, 3); // no kernel was run
    EXPECT_THAT(run(file.string()).text, HasSubstr("no kernel was run"));
    EXPECT_THAT(run(file.string() + " -- a").text, HasSubstr("the program returned 1"));
    fs::remove(file);
}

TEST(Run, SourcesInCAreNotCxx) {
    const fs::path folder = fs::temp_directory_path() / "raylab_run_test";
    fs::create_directories(folder);
    std::ofstream(folder / "kernel.cu") << "__global__ void k(int* p) { *p = 7; }\n"
                                           "extern \"C\" int seven() {\n"
                                           "  int* p; cudaMallocManaged(&p, 4); k<<<1, 1>>>(p);\n"
                                           "  cudaDeviceSynchronize(); return *p; }\n";
    std::ofstream(folder / "main.c") << "int seven(void);\n"
                                        "int main() { int class = seven(); return class != 7; }\n";
    const Outcome outcome = run(folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    fs::remove_all(folder);
}

TEST(CompilerErrors, InAHeaderAreToldAtTheLineThatLedThere) {
    const auto findings = compiler_errors("h.h: In function 'f':\n"
                                          "a.cu:9:3:   required from here\n"
                                          "h.h:70:1: error: static assertion failed\n"
                                          "a.cu:12: error: no\n",
                                          {"a.cu"}, "/tmp/x");
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].place, (simt::SourcePlace{"a.cu", 9, 3}));
    EXPECT_EQ(findings[1].place, (simt::SourcePlace{"a.cu", 12, 0}));
}

TEST(CompilerErrors, OfTheLinkerAreToldAtTheirLines) {
    const auto findings = compiler_errors(
        "/usr/bin/ld: /tmp/x/1_b.o: in function `twice(int)':\n"
        "/tmp/x/1/b.cu.cpp:3: multiple definition of `twice(int)'; "
        "/tmp/x/0_a.o:/tmp/x/common.cuh:3: first defined here\n"
        "/usr/bin/ld: /tmp/x/1_b.o:/tmp/x/common.cuh:2: multiple definition of `limit'; "
        "/tmp/x/0_a.o:/tmp/x/common.cuh:2: first defined here\n"
        "/usr/bin/ld: /tmp/x/0_a.o: in function `main':\n"
        "/tmp/x/a.cu:9: undefined reference to `missing(int)'\n"
        "/usr/bin/ld: 0_a.o:(.text+0x5): undefined reference to `other'\n",
        {"a.cu", "b.cu"}, "/tmp/x");
    ASSERT_EQ(findings.size(), 4u);
    EXPECT_EQ(findings[0].place, (simt::SourcePlace{"common.cuh", 3, 0}));
    EXPECT_THAT(findings[0].message, HasSubstr("twice(int) is defined here"));
    EXPECT_EQ(findings[1].place, (simt::SourcePlace{"common.cuh", 2, 0}));
    EXPECT_EQ(findings[2].place, (simt::SourcePlace{"a.cu", 9, 0}));
    EXPECT_THAT(findings[2].message, HasSubstr("missing(int)"));
    EXPECT_EQ(findings[3].place, (simt::SourcePlace{"a.cu", 0, 0}));
}

TEST(HostCode, IsTheProgramsOwnAlone) {
    bool understood = false;
    const auto read = [&](const std::string& words) {
        return findings_of_clang(words, {"/usr/"}, understood);
    };
    auto findings = read("a.cu:7:6: error: no matching function for call to 'f'\n"
                         "a.cu:1:2: note: candidate function not viable: requires 2 arguments\n"
                         "a.cu:2:2: note: candidate function not viable: call to __host__ function "
                         "from __global__ function\n");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].kind, "host-function");
    EXPECT_EQ(findings[0].place, (simt::SourcePlace{"a.cu", 7, 6}));
    EXPECT_THAT(findings[0].advice, HasSubstr("a.cu:2"));
    EXPECT_TRUE(understood);

    // A function of the library, and an error that is not about host code.
    findings =
        read("a.cu:7:6: error: reference to __host__ function 'sort' in __global__ function\n"
             "/usr/include/algorithm:2:2: note: 'sort' declared here\n");
    EXPECT_TRUE(findings.empty());
    EXPECT_FALSE(understood);
    findings = read("a.cu:7:6: error: use of undeclared identifier 'x'\n"
                    "a.cu:8:6: error: no matching function for call to 'g'\n"
                    "a.cu:2:2: note: candidate function not viable: call to __device__ function "
                    "from __host__ function\n");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].kind, "device-function");
    EXPECT_FALSE(understood);

    // Warnings are findings, of the program alone, and no reason to read no further.
    findings = read("a.cu:8:5: warning: variable 'sum' is uninitialized when used here "
                    "[-Wuninitialized]\n"
                    "/usr/include/x.h:1:1: warning: variable 'x' is uninitialized when used here "
                    "[-Wuninitialized]\n"
                    "a.cu:9:5: warning: format specifies type 'int' but the argument has type "
                    "'float' [-Wformat]\n");
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].kind, "uninitialised-local");
    EXPECT_THAT(findings[0].message, HasSubstr("variable sum is used before"));
    EXPECT_EQ(findings[1].kind, "printf-format");
    EXPECT_EQ(findings[1].severity, simt::Severity::warning);
    EXPECT_TRUE(understood);
}

TEST(Output, AnnotationsEscapeWhatEndsThem) {
    Result result;
    simt::Finding finding;
    finding.kind = "race";
    finding.place = {"a,b.cu", 3, 0};
    finding.message = "50% of\nall";
    result.findings = {finding};
    EXPECT_THAT(to_github(result), HasSubstr("file=a%2Cb.cu,line=3,title=race::50%25 of%0Aall"));
}

} // namespace
} // namespace raylab::app
