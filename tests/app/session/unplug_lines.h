#pragma once

#include "devices/open/sxi_framing.h"
#include "devices/transport/pty_server.h"
#include "devices/transport/tcp_server.h"
#include "devices/transport/udp_server.h"
#include "tests/app/session/unplug_cycles.h"

#include <filesystem>

namespace halbench::app {

/// Cables of a machine without hardware: the same port again in the network, another pseudo terminal under
/// the same name on a serial line.
class UnplugLines : public UnplugCycles {
protected:
    template <typename Server>
    std::unique_ptr<devices::ServerPort> plugIn(Result<Server> server) {
        EXPECT_TRUE(server) << server.error().message;
        uri = server->address();
        address = *devices::parseNetworkAddress(uri.substr(4));
        return std::make_unique<Server>(*std::move(server));
    }

    void runTcp(int cycles) {
        PluggableBoard board([this] { return plugIn(devices::TcpServer::listen(address)); });
        run(
            board, [this] { return uri; }, cycles);
    }
    void leaveTcpUnplugged() {
        PluggableBoard board([this] { return plugIn(devices::TcpServer::listen(address)); });
        leaveUnplugged(board, uri);
    }
    void runUdp(int cycles) {
        PluggableBoard board([this] { return plugIn(devices::UdpServer::bind(address)); });
        run(
            board, [this] { return uri; }, cycles);
    }
    void runSerial(int cycles) {
        const QTemporaryDir place;
        const std::filesystem::path name = place.filePath("ttyBoard").toStdString();
        PluggableBoard board(
            [&]() -> std::unique_ptr<devices::ServerPort> {
                auto line = devices::PtyServer::open(std::make_unique<devices::SxiFraming>());
                EXPECT_TRUE(line) << line.error().message;
                std::filesystem::remove(name);
                std::filesystem::create_symlink(line->address().substr(4), name);
                return std::make_unique<devices::PtyServer>(*std::move(line));
            },
            {"/begin XCP_ON_SxI 0x0100 115200 /end XCP_ON_SxI\n", HB_SXI_LONGEST_PACKET});
        run(
            board, [&] { return "serial:" + name.string() + "?baud=1000000"; }, cycles);
    }

private:
    devices::NetworkAddress address{"127.0.0.1", 0}; ///< the first time any port, then the same
    std::string uri;
};

} // namespace halbench::app
