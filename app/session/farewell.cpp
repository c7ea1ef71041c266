#include "app/session/farewell.h"

#include "app/session/connection.h"

#include <utility>

namespace halbench::app {

Farewell::Farewell(QObject& session, Job job) : QObject(&session), m_job(std::move(job)) {}

void Farewell::say(const QObject& session, Connection& connection) {
    for (const Farewell* farewell : session.findChildren<Farewell*>(QString(), Qt::FindDirectChildrenOnly)) {
        connection.post([job = farewell->m_job](devices::Device& device) {
            if (device.state().isConnected) {
                job(device);
            }
        });
    }
}

} // namespace halbench::app
