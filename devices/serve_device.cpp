#include "devices/serve_device.h"

#include "devices/simulated/simulated_device.h"
#include "devices/transport/tcp_server.h"

#include <fmt/format.h>

namespace halbench::devices {

namespace {

class ServedSimulation : public ServedBoard {
public:
    explicit ServedSimulation(SimulatedBoard& board) : m_board(&board) {}

    void advanceTo(double time_s) override { m_board->advanceTo(time_s); }
    void receive(std::span<const std::uint8_t> packet) override { m_board->receive(packet); }
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override {
        packet.resize(HB_MAX_DTO);
        packet.resize(m_board->transmit(packet));
        counter = m_board->messageCounter();
        return !packet.empty();
    }

private:
    SimulatedBoard* m_board;
};

} // namespace

Result<void> serveTcp(const ServeRequest& request, const std::function<void(const std::string&)>& onListening,
                      const std::atomic<int>& interruptSignal) {
    const Result<DeviceUri> uri = parseDeviceUri(request.device);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme != "sim") {
        return failure(ErrorCode::Usage, fmt::format("'{}' cannot be served", request.device),
                       "serve needs a simulated device, e.g. sim:htm");
    }
    const Result<std::unique_ptr<SimulatedBoard>> board = makeSimulatedBoard(*uri, request.seed);
    if (!board) {
        return failure(board.error());
    }
    const Result<TcpAddress> address = parseTcpAddress(request.address);
    if (!address) {
        return failure(address.error());
    }
    Result<TcpServer> server = TcpServer::listen(*address);
    if (!server) {
        return failure(server.error());
    }
    onListening("tcp:" + server->address().text());
    ServedSimulation served(**board);
    server->run(served, interruptSignal);
    return {};
}

} // namespace halbench::devices
