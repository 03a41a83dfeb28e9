// SPDX-License-Identifier: MIT
#include "host/broker/credentials.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/toml_reader.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::broker {
namespace {

namespace fs = std::filesystem;

class CredentialsTest : public testing::Test {
 protected:
  Credentials read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_credentials(file_);
  }

  tests::ScratchFolder folder_;
  fs::path file_ = folder_ / "robot1.toml";
};

TEST_F(CredentialsTest, AreReadAsTheyWereWritten) {
  const Credentials written{"lab", "192.168.1.7", 8883, "robot1", "se\"cr\\et", "/a b/ca.crt"};
  write_credentials(file_, written);
  const Credentials read = read_credentials(file_);
  EXPECT_EQ(read.fleet, written.fleet);
  EXPECT_EQ(read.host, written.host);
  EXPECT_EQ(read.port, written.port);
  EXPECT_EQ(read.user, written.user);
  EXPECT_EQ(read.password, written.password);
  EXPECT_EQ(read.ca_file, written.ca_file);
  const mqtt::ConnectionParams params = connection_params(read);
  EXPECT_EQ(params.client_id, "robot1");
  EXPECT_EQ(params.password, "se\"cr\\et");
}

TEST_F(CredentialsTest, NobodyElseCanReadThem) {
  std::ofstream(file_) << "open to all";
  write_credentials(file_, {"lab", "localhost", 1883, "robot1", "secret", ""});
  EXPECT_EQ(fs::status(file_).permissions() & fs::perms::all,
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_TRUE(read_credentials(file_).ca_file.empty());
}

TEST_F(CredentialsTest, ACaWithoutAFolderIsBesideThem) {
  const std::string rest = "fleet='lab'\nhost='h'\nuser='u'\npassword='p'\n";
  EXPECT_EQ(read(rest + "port=1883\nca='ca.crt'\n").ca_file, folder_ / "ca.crt");
  EXPECT_THROW(read(rest + "port=0\n"), files::ConfigError);
  EXPECT_THROW(read(rest + "port=65536\n"), files::ConfigError);
  EXPECT_THROW(read(rest + "port=1883\nca_file='ca.crt'\n"), files::ConfigError);
  EXPECT_THROW(read(rest), files::ConfigError);
}

}  // namespace
}  // namespace echomap::broker
