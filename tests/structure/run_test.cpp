// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/shell.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/support/scratch_folder.hpp"

// ./run, with stand-ins for the programs that would change the machine.
namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string run_script = shell_quoted(ECHOMAP_SOURCE_DIR "/run");

TEST(Run, HelpsWithEveryCommandFromAnyFolder) {
  const ShellResult overview = run_shell(run_script + " --help", "/");
  for (const std::string command :
       {"demo", "test", "setup", "build", "bench", "fuzz", "fmt", "lint", "flash"}) {
    const ShellResult result = run_shell(run_script + (" " + command) + " --help", "/");
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.output, HasSubstr("usage: ./run " + command));
    EXPECT_THAT(overview.output, HasSubstr("\n  " + command));
  }
}

TEST(Run, RefusesAnUnknownCommandAndNone) {
  const ShellResult unknown = run_shell(run_script + " dmeo", "/");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.output, HasSubstr("no command 'dmeo'"));
  EXPECT_EQ(run_shell(run_script, "/").exit_code, 2);
}

/// A folder of stand-ins that goes before everything else in PATH.
class RunWithStandIns : public testing::Test {
 protected:
  void stand_in(const std::string& program, const std::string& script) {
    std::ofstream(folder_ / program) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(folder_ / program, fs::perms::owner_all);
  }

  /// Every package but libpng-dev and cmake is installed.
  void lack_two_packages() {
    stand_in("dpkg-query",
             "for p; do :; done; case $p in libpng-dev | cmake) exit 1 ;; esac; printf installed");
  }

  ShellResult run(const std::string& arguments, const std::string& script = run_script) {
    return run_shell(
        "PATH=" + shell_quoted(folder_.path().string()) + ":$PATH " + script + " " + arguments,
        "/");
  }

  const fs::path& folder() const { return folder_.path(); }

 private:
  const tests::ScratchFolder folder_;
};

TEST_F(RunWithStandIns, SetupInstallsNothingWhereNothingIsMissing) {
  stand_in("dpkg-query", "printf installed");
  stand_in("apt-get", "echo apt-get was called");
  const ShellResult result = run("setup");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("nothing to install"));
  EXPECT_THAT(result.output, Not(HasSubstr("apt-get was called")));
}

TEST_F(RunWithStandIns, SetupAsRootInstallsExactlyWhatIsMissing) {
  lack_two_packages();
  stand_in("id", "echo 0");
  stand_in("apt-get", "echo \"called: $*\"");
  const ShellResult result = run("setup");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("will install, by apt-get: cmake libpng-dev"));
  EXPECT_THAT(result.output, HasSubstr("called: -q update"));
  EXPECT_THAT(result.output, HasSubstr("install --no-install-recommends cmake libpng-dev\n"));
}

TEST_F(RunWithStandIns, SetupInstallsTheSecondArchitectureOnlyWhenAskedTo) {
  stand_in("dpkg-query",
           "for p; do :; done; case $p in *arm* | libunicorn*) exit 1 ;; esac; printf installed");
  stand_in("id", "echo 0");
  stand_in("apt-get", "echo \"called: $*\"");
  EXPECT_THAT(run("setup").output, HasSubstr("nothing to install"));
  const ShellResult all = run("setup --all");
  EXPECT_EQ(all.exit_code, 0) << all.output;
  EXPECT_THAT(all.output,
              HasSubstr("will install, by apt-get: gcc-arm-none-eabi libnewlib-arm-none-eabi "
                        "libunicorn-dev qemu-system-arm"));
  EXPECT_EQ(run("setup --everything").exit_code, 2);
}

TEST_F(RunWithStandIns, SetupAsSomeoneElseGoesThroughSudo) {
  lack_two_packages();
  stand_in("id", "echo 1000");
  stand_in("sudo", "echo \"sudo: $*\"");
  const ShellResult result = run("setup");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("will install with sudo"));
  EXPECT_THAT(result.output, HasSubstr("sudo: apt-get -q update"));
  EXPECT_THAT(result.output, HasSubstr("sudo: env DEBIAN_FRONTEND=noninteractive apt-get"));
}

TEST_F(RunWithStandIns, SetupSaysWhatToDoWhereAptGetFails) {
  lack_two_packages();
  stand_in("id", "echo 0");
  stand_in("apt-get", "exit 100");
  const ShellResult result = run("setup");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("run it by hand to see why"));
}

/// A tree of its own, with stand-ins for all that ./run flash calls.
class RunFlash : public RunWithStandIns {
 protected:
  void SetUp() override {
    RunWithStandIns::SetUp();
    stand_in("dpkg-query", "printf installed");
    stand_in("cmake", "echo \"called: cmake $*\"; echo echomap: phony; echo firmware_uno: phony");
    fs::create_directories(build_ / "bin");
    for (const std::string name : {"run", "packages.txt"}) {
      fs::copy_file(fs::path(ECHOMAP_SOURCE_DIR) / name, folder() / "tree" / name);
    }
    stand_in("tree/build/release/bin/echomap", "echo \"called: echomap $*\"; exit 3");
  }
  ShellResult run_flash(const std::string& arguments) {
    return run("flash " + arguments, shell_quoted((folder() / "tree" / "run").string()));
  }

  const fs::path build_ = folder() / "tree" / "build" / "release";
};

TEST_F(RunFlash, BuildsTheBoardThatIsAskedForAndLeavesTheRestToTheProgram) {
  const ShellResult result = run_flash("--board nano --port /dev/ttyUSB0");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.output, HasSubstr("--target echomap firmware_uno\n"));
  EXPECT_THAT(result.output, HasSubstr("called: echomap flash --board nano --port /dev/ttyUSB0\n"));
}

TEST_F(RunFlash, ConfiguresAnewAfterAConfigurationThatFailed) {
  std::ofstream(build_ / "CMakeCache.txt") << "half of it\n";
  EXPECT_THAT(run_flash("").output, HasSubstr("--preset release"));
  std::ofstream(build_ / "build.ninja") << "\n";
  EXPECT_THAT(run_flash("").output, Not(HasSubstr("--preset")));
}

/// As after ./run setup --all in a tree that ./run demo has configured.
TEST_F(RunFlash, ConfiguresAnewForABoardWhoseCompilerHasComeSince) {
  std::ofstream(build_ / "build.ninja") << "\n";
  stand_in("cmake",
           "case $* in *--preset*) echo >" + shell_quoted((build_ / "anew").string()) +
               ";; *help) echo echomap: phony; [ ! -e " + shell_quoted((build_ / "anew").string()) +
               " ] || echo firmware_ev3: phony ;; *) echo \"built:${*##*--target}\" ;; esac");
  const ShellResult result = run_flash("--board ev3");
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_THAT(result.output, HasSubstr("built: echomap firmware_ev3\n"));
}

TEST_F(RunFlash, SaysHowToGetTheCompilerOfABoardThatItCannotBuild) {
  std::ofstream(build_ / "build.ninja") << "\n";
  const ShellResult result = run_flash("--board pico");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("next: ./run setup --all"));
  EXPECT_THAT(result.output, Not(HasSubstr("called: echomap")));
}

/// ./run demo, with a cmake that knows every target.
class RunDemo : public RunFlash {
 protected:
  void SetUp() override {
    RunFlash::SetUp();
    stand_in("cmake",
             "case $* in *help) for t in echomap echomap-mock echomap-simavr echomap-unicorn "
             "echomap-ev3 echomap-rp2040 firmware_ev3-usual firmware_pico-usual "
             "firmware_uno-usual firmware_mega-usual firmware_stm32f103-usual; do echo \"$t: "
             "phony\"; done ;; *) echo \"built:${*##*--target}\" ;; esac");
  }
  std::string built_for(const std::string& arguments) {
    const std::string output =
        run("demo " + arguments, shell_quoted((folder() / "tree" / "run").string())).output;
    const std::size_t begin = output.find("built: ") + 7;
    return output.substr(begin, output.find('\n', begin) - begin);
  }
};

TEST_F(RunDemo, BuildsOnlyWhatItsArgumentsNeed) {
  std::ofstream(build_ / "build.ninja") << "\n";
  EXPECT_EQ(built_for("--headless"), "echomap echomap-simavr firmware_uno-usual");
  EXPECT_EQ(built_for("--emulator mock"), "echomap echomap-mock");
  EXPECT_EQ(built_for("--seed 3 --board=mega"), "echomap echomap-simavr firmware_mega-usual");
  EXPECT_EQ(built_for("--board stm32f103"), "echomap echomap-unicorn firmware_stm32f103-usual");
  EXPECT_EQ(built_for("--emulator=unicorn"), "echomap echomap-unicorn firmware_stm32f103-usual");
  EXPECT_EQ(built_for("--board ev3"), "echomap echomap-ev3 firmware_ev3-usual");
  EXPECT_EQ(built_for("--board=pico --seed 3"), "echomap echomap-rp2040 firmware_pico-usual");
  EXPECT_EQ(built_for("--emulator rp2040"), "echomap echomap-rp2040 firmware_pico-usual");
}

/// ./run test, with a ctest that leaves a log of two tests.
class RunTest : public RunFlash {
 protected:
  void SetUp() override {
    RunFlash::SetUp();
    stand_in("ctest", "echo \"called: ctest $*\"");
    fs::create_directories(build_ / "Testing" / "Temporary");
    std::ofstream(build_ / "Testing" / "Temporary" / "LastTest.log")
        << "1/2 Testing: sensors_test\n"
        << "[       OK ] Odometry.Turns (1500 ms)\n[       OK ] Odometry.Stands (20 ms)\n"
        << "measured: 1.50 s of processor, 40 MB\nTest time =   1.60 sec\n"
        << "2/2 Testing: fuzz.log\n"
        << "measured: 2.10 s of processor, 90 MB\nTest time =   2.25 sec\n";
  }
  ShellResult run_test(const std::string& arguments) {
    return run("test " + arguments, shell_quoted((folder() / "tree" / "run").string()));
  }
};

TEST_F(RunTest, BuildsAndRunsWhatItsTierNames) {
  const std::string quick = run_test("--quick").output;
  EXPECT_THAT(quick, HasSubstr("--target quick_tests\n"));
  EXPECT_THAT(quick, HasSubstr(" -L quick\n"));
  const std::string standard = run_test("").output;
  EXPECT_THAT(standard, HasSubstr("--target standard_tests\n"));
  EXPECT_THAT(standard, HasSubstr(" -LE full\n"));
  const std::string full = run_test("--full").output;
  EXPECT_THAT(full, Not(HasSubstr("--target")));
  EXPECT_THAT(full, Not(HasSubstr(" -L")));
  EXPECT_THAT(run_test("--asan").output, HasSubstr("-LE structure|hil|full\n"));
}

TEST_F(RunTest, BuildsAProgramBeforeItRunsItsCases) {
  const fs::path program = build_ / "bin" / "long_test";
  fs::create_directories(program.parent_path());
  std::ofstream(program)
      << "#!/bin/sh\n"
         "case $* in *list*) printf 'Pose2.\\n  Turns\\n' ;; *) echo ran ;; esac\n";
  fs::permissions(program, fs::perms::owner_all);
  const std::string output = run_test("--cases 'Pose2*'").output;
  const std::size_t ran = output.find("\nran\n");
  ASSERT_NE(ran, std::string::npos) << output;
  EXPECT_LT(output.find("--target long_test\n"), ran) << output;
}

TEST_F(RunTest, TellsTheSlowestCasesAndWhatAllTook) {
  const std::string output = run_test("--quick").output;
  EXPECT_THAT(output,
              HasSubstr("  2.25 s  fuzz.log\n  1.50 s  Odometry.Turns\n"
                        "  0.02 s  Odometry.Stands\n"));
  EXPECT_THAT(output, HasSubstr("run: 4 s of processor in 0:0"));
  EXPECT_THAT(output, HasSubstr("most memory: 90 MB, fuzz.log\n"));
}

/// ./run lint in a repository of its own, with a clang-tidy that names its file.
class RunLint : public RunFlash {
 protected:
  void SetUp() override {
    RunFlash::SetUp();
    stand_in("clang-tidy-16", "for file; do :; done; echo \"checks ${file##*/}\"");
    fs::create_directories(tree_ / "build" / "lint");
    std::ofstream database(tree_ / "build" / "lint" / "compile_commands.json");
    for (const std::string name : {"a.cpp", "b.cpp", "c.cpp"}) {
      database << "  \"file\": \"" << (tree_ / name).string() << "\"\n";
      std::ofstream(tree_ / name) << "#include \"" << name[0] << ".hpp\"\n#include \"d.hpp\"\n";
    }
    commit("first");
  }
  void commit(const std::string& subject) {
    const ShellResult result = run_shell(
        "git init --quiet; git add '*.?pp'; git -c user.name=a -c user.email=a@b commit --quiet "
        "--message " +
            subject,
        tree_);
    ASSERT_EQ(result.exit_code, 0) << result.output;
  }
  std::string changed() {
    return run("lint --changed", shell_quoted((tree_ / "run").string())).output;
  }

  const fs::path tree_ = folder() / "tree";
};

TEST_F(RunLint, ChecksWhatTheLastCommitChanged) {
  std::ofstream(tree_ / "b.cpp") << "#include \"d.hpp\"\n";
  commit("second");
  EXPECT_THAT(changed(), HasSubstr("checks b.cpp\n"));
  EXPECT_THAT(changed(), HasSubstr("clang-tidy finds nothing in 1 files"));
}

TEST_F(RunLint, ChecksAHeaderByASourceThatIncludesIt) {
  std::ofstream(tree_ / "c.hpp") << "int c();\n";
  std::ofstream(tree_ / "d.hpp") << "int d();\n";
  commit("second");
  EXPECT_THAT(changed(), HasSubstr("checks c.cpp\n"));
  EXPECT_THAT(changed(), HasSubstr("checks a.cpp\n"));
  EXPECT_THAT(changed(), Not(HasSubstr("checks b.cpp\n")));
}

TEST_F(RunLint, ShowsWhatClangTidyFindsAndFails) {
  stand_in("clang-tidy-16", "for file; do :; done; echo \"$file:1:1: error: odd\"; exit 1");
  const ShellResult result = run("lint " + shell_quoted((tree_ / "a.cpp").string()),
                                 shell_quoted((tree_ / "run").string()));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("a.cpp:1:1: error: odd\n"));
  EXPECT_THAT(result.output, HasSubstr("clang-tidy found something"));
}

TEST_F(RunLint, NamesWhatItHadNoTimeFor) {
  std::ofstream(tree_ / "b.cpp") << "#include \"d.hpp\"\n";
  commit("second");
  const ShellResult result =
      run("lint --changed --seconds 0", shell_quoted((tree_ / "run").string()));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, Not(HasSubstr("checks b.cpp")));
  EXPECT_THAT(result.output,
              HasSubstr("not linted are 1 files; next: ./run lint --changed\n  b.cpp"));
}

TEST_F(RunLint, SaysSoWhereNoCommitBeforeIsHere) {
  EXPECT_THAT(changed(), HasSubstr("nothing to compare with"));
}

/// ./run fuzz, with a cmake that names two decoders and "builds" them: one sound, one that breaks.
class RunFuzz : public RunFlash {
 protected:
  void SetUp() override {
    RunFlash::SetUp();
    stand_in("cmake", "echo fuzz_sound: phony; echo fuzz_brittle: phony");
    stand_in("clang++-16", "exit 0");
    const fs::path bin = folder() / "tree" / "build" / "fuzz" / "bin";
    fs::create_directories(bin);
    const std::string seeds = "[ \"$1\" != --seeds ] || { printf 0123 > \"$2/seed-1\"; exit 0; }\n";
    stand_in("tree/build/fuzz/bin/fuzz_sound",
             seeds + "echo \"arguments: $*\"; echo 'stat::number_of_executed_units: 17'");
    stand_in("tree/build/fuzz/bin/fuzz_brittle", seeds + "echo broken promise; exit 77");
  }
  ShellResult run_fuzz(const std::string& arguments) {
    return run("fuzz " + arguments, shell_quoted((folder() / "tree" / "run").string()));
  }
};

TEST_F(RunFuzz, SaysHowOftenADecoderRanAndNothingWasFound) {
  const ShellResult result = run_fuzz("sound --runs 17");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("sound: 17 runs, nothing found"));
  const auto log = read_lines(folder() / "tree" / "build" / "fuzz" / "sound.log");
  EXPECT_THAT(log.front(), HasSubstr("arguments: -runs=17 -max_len=256"));
}

TEST_F(RunFuzz, ShowsWhatBreaksADecoder) {
  const ShellResult result = run_fuzz("--seconds 1");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("sound: 17 runs"));
  EXPECT_THAT(result.output, HasSubstr("broken promise"));
  EXPECT_THAT(result.output, HasSubstr("brittle breaks: the input is in build/fuzz/findings"));
}

TEST_F(RunFuzz, NamesTheDecodersWhereItKnowsNoneOfThatName) {
  const ShellResult result = run_fuzz("sond");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("no decoder 'sond'; there are: sound brittle"));
}

}  // namespace
}  // namespace echomap::structure
