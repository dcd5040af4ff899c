// Ctrl-C, SIGTERM and SIGHUP, as a person meets them: what was rendered is in a complete file, and
// a sentence says so.
#include "app/tests/cli.h"

#include "common/cli/files.h"
#include "common/image/image_file.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>

namespace raylab::app {
namespace {

using testing::HasSubstr;
using testing::Not;

// A program that runs while the test goes on. Its output goes to a file.
class Running {
  public:
    Running(const std::string& arguments, const std::string& output) : output_(output) {
        pid_ = fork();
        if (pid_ != 0) return;
        setpgid(0, 0);
        const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        // exec: the signal is for the program, not for a shell.
        execl("/bin/sh", "sh", "-c", ("exec " RAYLAB_PROGRAM " " + arguments).c_str(), nullptr);
        _exit(127);
    }
    void send(int signal) {
        sent_ = std::chrono::steady_clock::now();
        kill(pid_, signal);
    }
    Outcome wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - sent_).count();
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(output_)};
    }
    double seconds() const { return seconds_; } // from the last signal to the end

  private:
    std::string output_;
    pid_t pid_;
    std::chrono::steady_clock::time_point sent_;
    double seconds_ = 0;
};

void sleep_seconds(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

class InterruptCli : public Cli {
  protected:
    void SetUp() override {
        write_scene("s.json");
        // Lab 01 tests every triangle: some seconds a sample.
        write_scene("slow.json", R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1,)",
                    R"({"kind": "procedural", "mesh": "terrain", "triangles": 400000,)");
    }

    void expect_no_litter() const {
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".part")));
    }

    void wait_for(const std::string& name) const {
        for (int i = 0; i < 6000 && !fs::exists(in(name)); ++i) sleep_seconds(0.01);
        ASSERT_TRUE(fs::exists(in(name)));
    }
};

TEST_F(InterruptCli, ARenderIsKeptWithTheSamplesItHas) {
    for (const auto& [signal, name] :
         {std::pair(SIGINT, "SIGINT"), std::pair(SIGTERM, "SIGTERM"), std::pair(SIGHUP, "SIGHUP")})
        for (const std::string lab : {"01", "02"}) {
            fs::remove(in("o_0003.exr"));
            Running render("render " + lab + " " + in("s.json") +
                               " -q --spp 1000000 --snapshots 3 --stats " + in("l.json") + " -o " +
                               in("o.exr"),
                           in("said"));
            wait_for("o_0003.exr");
            render.send(signal);
            const Outcome outcome = render.wait();
            EXPECT_EQ(outcome.code, 128 + signal) << outcome.text;
            const int spp = read_image(in("o.exr")).provenance.spp;
            EXPECT_GE(spp, 3);
            EXPECT_EQ(outcome.text,
                      fmt::format("raylab: interrupted by {}: '{}' has {} of 1000000 samples a "
                                  "pixel\n",
                                  name, in("o.exr"), spp));
            const auto ledger = nlohmann::json::parse(read_file(in("l.json")));
            EXPECT_EQ(ledger["samples"], spp);
            EXPECT_EQ(ledger["bounces"][0]["rays"], 64 * spp);
            expect_no_litter();
            if (signal != SIGINT) continue;
            // Compares, bit for bit, with a render that was asked for this number of samples.
            raylab(fmt::format("render {} {} -q --spp {} -o {}", lab, in("s.json"), spp,
                               in("whole.exr")));
            EXPECT_TRUE(read_file(in("o.exr")) == read_file(in("whole.exr"))) << lab;
        }
}

TEST_F(InterruptCli, TimeoutThatSendsTwiceKeepsTheRenderToo) {
    const Outcome outcome =
        run_in_shell("timeout --preserve-status -s INT 1 " RAYLAB_PROGRAM " render 01 " +
                     in("s.json") + " -q --spp 1000000 -o " + in("o.exr"));
    EXPECT_EQ(outcome.code, 130) << outcome.text;
    EXPECT_TRUE(fs::exists(in("o.exr"))) << outcome.text;
}

// A sample that takes long is not waited for, and the samples before it are kept.
TEST_F(InterruptCli, ALongSampleIsNotWaitedFor) {
    Running render("render 01 " + in("slow.json") +
                       " -q --threads 1 --width 220 --height 220 --spp 100 --snapshots 1 -o " +
                       in("o.exr"),
                   in("said"));
    wait_for("o_0001.exr");
    render.send(SIGINT);
    const Outcome outcome = render.wait();
    EXPECT_EQ(outcome.code, 130) << outcome.text;
    EXPECT_LT(render.seconds(), 2);
    EXPECT_THAT(outcome.text, HasSubstr("has 1 of 100 samples a pixel"));
    EXPECT_TRUE(read_file(in("o.exr")) == read_file(in("o_0001.exr")));
    expect_no_litter();
}

TEST_F(InterruptCli, WithoutASampleNothingIsWrittenAndASecondSignalDoesNotWait) {
    const std::string arguments = "render 01 " + in("slow.json") +
                                  " -q --threads 1 --width 500 --height 500 --spp 100 -o " +
                                  in("new/o.exr");
    Running once(arguments, in("said"));
    wait_for("new"); // the scene is loaded
    sleep_seconds(0.2);
    once.send(SIGTERM);
    const Outcome outcome = once.wait();
    EXPECT_EQ(outcome.code, 143) << outcome.text;
    EXPECT_EQ(outcome.text, "raylab: interrupted by SIGTERM before the first sample was finished: "
                            "nothing was written\n");
    EXPECT_LT(once.seconds(), 2);
    EXPECT_TRUE(fs::is_empty(in("new")));

    fs::remove(in("new"));
    Running twice(arguments, in("said"));
    wait_for("new");
    sleep_seconds(0.2);
    twice.send(SIGINT);
    sleep_seconds(0.5);
    twice.send(SIGINT);
    EXPECT_EQ(twice.wait().code, 130);
    EXPECT_LT(twice.seconds(), 0.4);
    EXPECT_TRUE(fs::is_empty(in("new")));
}

TEST_F(InterruptCli, WhatCannotBeKeptIsSaid) {
    fs::create_directory(in("folder"));
    Running render("render 01 " + in("s.json") + " -q --spp 1000000 --snapshots 3 -o " +
                       in("folder/o.exr"),
                   in("said"));
    wait_for("folder/o_0003.exr");
    fs::remove_all(in("folder"));
    render.send(SIGINT);
    const Outcome outcome = render.wait();
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("there is no folder"));
}

// Other long commands keep their finished parts. The test cannot see when a part is finished, so it
// waits longer at each try.
class OtherInterrupts : public InterruptCli {
  protected:
    Outcome interrupted_when_some_is_finished(const std::string& arguments,
                                              const std::string& words) const {
        Outcome outcome{0, ""};
        for (const double seconds : {1.5, 6.0, 24.0}) {
            Running work(arguments, in("said"));
            sleep_seconds(seconds);
            work.send(SIGINT);
            outcome = work.wait();
            EXPECT_LT(work.seconds(), 5);
            if (outcome.text.find(words) != std::string::npos) break;
        }
        EXPECT_EQ(outcome.code, 130) << outcome.text;
        EXPECT_THAT(outcome.text, HasSubstr("raylab: interrupted by SIGINT"));
        EXPECT_THAT(outcome.text, HasSubstr(words));
        expect_no_litter();
        return outcome;
    }
};

TEST_F(OtherInterrupts, AReferenceKeepsItsReplicatesUnlessOneOfMoreSamplesIsThere) {
    const std::string reference = "reference " + in("s.json") + " -o " + in("r");
    interrupted_when_some_is_finished(reference + " --replicates 1024 --spp 2048000",
                                      " of 1024 replicates");
    const Image image = read_image(in("r/s.exr"));
    EXPECT_GE(image.provenance.spp, 2 * 2000);
    EXPECT_EQ(image.provenance.spp % 2000, 0);
    EXPECT_EQ(image.error.size(), 64u);

    // Two replicates of one sample each are finished in no time.
    const std::string before = read_file(in("r/s.exr"));
    interrupted_when_some_is_finished("reference " + in("slow.json") + " -o " + in("r") +
                                          " --replicates 2 --spp 2000000",
                                      "was not written, since a variance takes two replicates");
    EXPECT_FALSE(fs::exists(in("r/slow.exr")));
    Running shorter(reference + " --replicates 1024 --spp 1024000", in("said"));
    sleep_seconds(0.1);
    shorter.send(SIGINT);
    EXPECT_EQ(shorter.wait().code, 130);
    EXPECT_TRUE(read_file(in("r/s.exr")) == before);
}

TEST_F(OtherInterrupts, ABenchKeepsItsScenes) {
    interrupted_when_some_is_finished("bench " + in("s.json") + " " + in("slow.json") +
                                          " --peers none --labs 01 --spp 1,1000 -o " + in("out"),
                                      "out/bench.html' has 1 of 2 scenes");
    EXPECT_EQ(nlohmann::json::parse(read_file(in("out/bench.json")))["scenes"].size(), 1u);
}

TEST_F(OtherInterrupts, ABenchOfRaysKeepsItsMeshes) {
    interrupted_when_some_is_finished(
        "bench-rays terrain:100 terrain:200000 --structures brute --size 32x32 --verify 0 -o " +
            in("out"),
        "out/rays.html' has 1 of 2 meshes");
    EXPECT_TRUE(fs::exists(in("out/rays.html")));
}

TEST_F(OtherInterrupts, ADemoWithoutAnImageSaysSo) {
    Running demo("demo cornell -o " + in("out"), in("said"));
    wait_for("out");
    sleep_seconds(0.1);
    demo.send(SIGINT);
    const Outcome outcome = demo.wait();
    EXPECT_EQ(outcome.code, 130) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("before the first image was judged: nothing was written"));
    EXPECT_TRUE(fs::is_empty(in("out")));
}

} // namespace
} // namespace raylab::app
