// Limits on memory, read from a tree of files as Linux shows them.
#include "common/cli/memory.h"

#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace raylab {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t mib = 1 << 20;

class Memory : public testing::Test {
  protected:
    void SetUp() override {
        write("/proc/meminfo", "MemTotal:       99999999 kB\nMemAvailable:   1048576 kB\n");
    }

    void write(const std::string& name, const std::string& text) const {
        prepare_output(root + name);
        write_file(root + name, text);
    }

    TemporaryFolder temporary;
    const std::string root = temporary.path().string();
};

TEST_F(Memory, OfTheMachine) {
    EXPECT_EQ(available_memory(root).bytes, 1024 * mib);
    EXPECT_EQ(available_memory(root).limit, "the machine has no more free");
}

// The group itself has no limit, but the group above it has. Memory that cached files take counts
// as available.
TEST_F(Memory, OfControlGroups) {
    write("/proc/self/cgroup", "0::/job/step\n");
    write("/sys/fs/cgroup/job/step/memory.max", "max\n");
    write("/sys/fs/cgroup/job/step/memory.current", "104857600\n");
    write("/sys/fs/cgroup/job/memory.max", "524288000\n");
    write("/sys/fs/cgroup/job/memory.current", "314572800\n");
    write("/sys/fs/cgroup/job/memory.stat", "anon 1\nfile 2\ninactive_file 104857600\n");
    EXPECT_EQ(available_memory(root).bytes, (500 - 300 + 100) * mib);
    EXPECT_EQ(available_memory(root).limit, "the limit of this container or job");
}

TEST_F(Memory, OfTheRootGroupAsContainersSeeIt) {
    write("/proc/self/cgroup", "0::/\n");
    write("/sys/fs/cgroup/memory.max", "209715200\n");
    write("/sys/fs/cgroup/memory.current", "104857600\n");
    EXPECT_EQ(available_memory(root).bytes, 100 * mib);
}

TEST_F(Memory, OfControlGroupsOfVersion1) {
    write("/proc/self/cgroup", "5:cpu,cpuacct:/x\n4:memory:/docker/1\n");
    write("/sys/fs/cgroup/memory/docker/1/memory.limit_in_bytes", "209715200\n");
    write("/sys/fs/cgroup/memory/docker/1/memory.usage_in_bytes", "209715300\n");
    EXPECT_EQ(available_memory(root).bytes, 0u);
}

TEST_F(Memory, ForPeople) {
    EXPECT_EQ(human_bytes(1000), "1000 bytes");
    EXPECT_EQ(human_bytes(1.5 * mib), "1.5 MiB");
    EXPECT_EQ(human_bytes(7680.0 * 4320 * 180), "5.56 GiB");
    EXPECT_GT(peak_memory(), mib);
}

} // namespace
} // namespace raylab
