#include "app/session/disconnect_task.h"

#include "app/session/connection.h"

#include <utility>

namespace halbench::app {

DisconnectTask::DisconnectTask(QObject& session, Job job) : QObject(&session), m_job(std::move(job)) {}

void DisconnectTask::say(const QObject& session, Connection& connection) {
    for (const DisconnectTask* disconnectTask :
         session.findChildren<DisconnectTask*>(QString(), Qt::FindDirectChildrenOnly)) {
        connection.post([job = disconnectTask->m_job](devices::Device& device) {
            if (device.state().isConnected) {
                job(device);
            }
        });
    }
}

} // namespace halbench::app
