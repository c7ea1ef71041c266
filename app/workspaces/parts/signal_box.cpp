#include "app/workspaces/parts/signal_box.h"

#include "app/workbench/display_quantity.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalBlocker>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int LeastCharacters = 12;

} // namespace

SignalBox::SignalBox(QWidget* parent) : QComboBox(parent) {
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(LeastCharacters);
    setAcceptDrops(true);
    connect(this, QOverload<int>::of(&QComboBox::activated), this, &SignalBox::chosen);
}

void SignalBox::setCatalogue(const devices::Catalogue& catalogue, const std::vector<const char*>& roles) {
    const QSignalBlocker quiet(this);
    QString wanted = currentData().toString();
    clear();
    for (const SignalSpec& spec : catalogue.signals) {
        addItem(signalWords(spec.name), QString::fromStdString(spec.name));
    }
    for (const char* role : roles) {
        if (findData(wanted) < 0) {
            wanted = QString::fromStdString(catalogue.signalForRole(role));
        }
    }
    setCurrentIndex(count() > 0 ? std::max(0, findData(wanted)) : -1);
}

std::string SignalBox::signal() const {
    return currentData().toString().toStdString();
}

void SignalBox::choose(const QString& name) {
    if (const int index = findData(name); index >= 0) {
        setCurrentIndex(index);
        Q_EMIT chosen();
    }
}

void SignalBox::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(widgets::SignalsMimeType))) {
        event->acceptProposedAction();
    }
}

void SignalBox::dropEvent(QDropEvent* event) {
    const QByteArray names = event->mimeData()->data(QLatin1String(widgets::SignalsMimeType));
    event->acceptProposedAction();
    choose(QString::fromUtf8(names).section(QLatin1Char('\n'), 0, 0));
}

} // namespace halbench::app
