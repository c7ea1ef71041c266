#include "app/workbench/drive_commands.h"

#include "widgets/language/phrasebook.h"

#include <QPointer>

#include <utility>

namespace halbench::app {

void DriveCommands::run(Action action, std::function<void()> then) {
    m_bench.session().request(std::move(action),
                              [self = QPointer(this), then = std::move(then)](const Result<void>& done) {
                                  if (self) {
                                      self->finish(done, then);
                                  }
                              });
}

void DriveCommands::write(std::vector<ParameterValue> values, std::function<void()> then) {
    run([values = std::move(values)](devices::Device& device) { return device.writeParameters(values); },
        std::move(then));
}

void DriveCommands::change(Action action, std::function<void()> then) {
    const std::uint64_t number = ++m_changes;
    m_pending = number;
    Q_EMIT jogEnds();
    m_bench.session().requestUnlessStopped(
        std::move(action), [self = QPointer(this), number, then = std::move(then)](const Result<void>& done) {
            if (self) {
                self->m_pending = self->m_pending == number ? 0 : self->m_pending;
                self->finish(done, then);
            }
        });
    Q_EMIT changed();
}

void DriveCommands::finish(const Result<void>& done, const std::function<void()>& then) {
    if (!done) {
        Q_EMIT jogEnds();
        Q_EMIT failed(widgets::inWords(done.error().message), widgets::inWords(done.error().hint));
    } else if (then) {
        then();
    }
    Q_EMIT changed();
}

} // namespace halbench::app
