// SPDX-License-Identifier: MIT
#include "host/broker/certificates.hpp"

#include <set>
#include <utility>

#include <arpa/inet.h>

#include "host/broker/program.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::broker {
namespace {

namespace fs = std::filesystem;

constexpr auto kCaDays = "3650";
constexpr auto kServerDays = "825";

bool is_ip_address(const std::string& host) {
  in6_addr bytes{};
  return ::inet_pton(AF_INET, host.c_str(), &bytes) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), &bytes) == 1;
}

/// Calls of the openssl program, in one folder.
class OpenSsl {
 public:
  explicit OpenSsl(fs::path folder)
      : program_(find_program({"openssl", "openssl"})), folder_(std::move(folder)) {}

  std::string file(const char* name) const { return (folder_ / name).string(); }

  void run(std::vector<std::string> words, const std::string& what) const {
    words.insert(words.begin(), program_.string());
    run_program(words, what, folder_ / "openssl.log");
  }

  void make_key(const char* name) const {
    run({"ecparam", "-name", "prime256v1", "-genkey", "-noout", "-out", file(name)}, "make a key");
    fs::permissions(file(name), fs::perms::owner_read | fs::perms::owner_write);
  }

 private:
  fs::path program_;
  fs::path folder_;
};

void make_ca(const OpenSsl& openssl, const std::string& fleet) {
  openssl.make_key("ca.key");
  openssl.run({"req",
               "-x509",
               "-new",
               "-sha256",
               "-key",
               openssl.file("ca.key"),
               "-days",
               kCaDays,
               "-subj",
               "/CN=echomap CA of " + fleet,
               "-addext",
               "basicConstraints=critical,CA:TRUE,pathlen:0",
               "-addext",
               "keyUsage=critical,keyCertSign,cRLSign",
               "-out",
               openssl.file("ca.crt")},
              "make a CA");
}

/// What a certificate for these hosts says besides its key.
std::string extensions_for(const std::vector<std::string>& hosts) {
  std::string text =
      "basicConstraints=critical,CA:FALSE\n"
      "keyUsage=critical,digitalSignature\n"
      "extendedKeyUsage=serverAuth\n"
      "subjectAltName=";
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    text += (i == 0 ? "" : ",") + std::string(is_ip_address(hosts[i]) ? "IP:" : "DNS:") + hosts[i];
  }
  return text + "\n";
}

void make_server_certificate(const OpenSsl& openssl, const std::vector<std::string>& hosts) {
  openssl.make_key("server.key");
  openssl.run({"req",
               "-new",
               "-sha256",
               "-key",
               openssl.file("server.key"),
               "-subj",
               "/CN=" + hosts.front(),
               "-out",
               openssl.file("server.csr")},
              "ask for a certificate");
  files::write_text_file(openssl.file("server.ext"), extensions_for(hosts));
  openssl.run({"x509",
               "-req",
               "-sha256",
               "-in",
               openssl.file("server.csr"),
               "-CA",
               openssl.file("ca.crt"),
               "-CAkey",
               openssl.file("ca.key"),
               "-CAcreateserial",
               "-days",
               kServerDays,
               "-extfile",
               openssl.file("server.ext"),
               "-out",
               openssl.file("server.crt")},
              "sign a certificate");
}

}  // namespace

Certificates make_certificates(const fs::path& folder,
                               const std::string& fleet,
                               const std::vector<std::string>& hosts) {
  const OpenSsl openssl(folder);
  fs::create_directories(folder);
  if (!fs::exists(openssl.file("ca.crt")) || !fs::exists(openssl.file("ca.key"))) {
    make_ca(openssl, fleet);
  }
  make_server_certificate(openssl, hosts);
  return {openssl.file("ca.crt"), openssl.file("server.crt"), openssl.file("server.key")};
}

}  // namespace echomap::broker
