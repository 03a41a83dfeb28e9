// SPDX-License-Identifier: MIT
#include "host/broker/certificates.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/broker/program.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::broker {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CertificatesTest : public testing::Test {
 protected:
  /// What openssl prints of a certificate.
  std::string text_of(const std::filesystem::path& certificate) const {
    return printed({"x509", "-in", certificate.string(), "-noout", "-text"});
  }
  std::string printed(std::vector<std::string> words) const {
    words.insert(words.begin(), find_program({"openssl", "openssl"}).string());
    run_program(words, "print", folder_ / "printed");
    return files::read_text_file(folder_ / "printed");
  }
  Certificates make(const std::vector<std::string>& hosts) const {
    return make_certificates(folder_ / "tls", "lab", hosts);
  }

  tests::ScratchFolder folder_;
};

TEST_F(CertificatesTest, AreForTheHostsAndByACaThatMaySignNothingElse) {
  const Certificates made = make({"localhost", "127.0.0.1", "::1", "robots.example"});
  EXPECT_THAT(text_of(made.server),
              AllOf(HasSubstr("DNS:localhost, IP Address:127.0.0.1, IP Address:0:0:0:0:0:0:0:1, "
                              "DNS:robots.example"),
                    HasSubstr("CA:FALSE"),
                    HasSubstr("prime256v1"),
                    HasSubstr("TLS Web Server Authentication")));
  EXPECT_THAT(text_of(made.ca),
              AllOf(HasSubstr("CA:TRUE, pathlen:0"), HasSubstr("CN = echomap CA of lab")));
  EXPECT_THAT(printed({"verify", "-CAfile", made.ca.string(), made.server.string()}),
              HasSubstr("OK"));
}

TEST_F(CertificatesTest, TheCaStaysWhenTheServerIsCertifiedAgain) {
  const Certificates first = make({"localhost"});
  const std::string ca = files::read_text_file(first.ca);
  const std::string server = files::read_text_file(first.server);
  const Certificates second = make({"localhost", "robots.example"});
  EXPECT_EQ(files::read_text_file(second.ca), ca);
  EXPECT_NE(files::read_text_file(second.server), server);
}

TEST_F(CertificatesTest, KeysAreTheUsersAlone) {
  const Certificates made = make({"localhost"});
  for (const auto& key : {made.server_key, folder_ / "tls" / "ca.key"}) {
    EXPECT_EQ(std::filesystem::status(key).permissions() & std::filesystem::perms::all,
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  }
}

}  // namespace
}  // namespace echomap::broker
