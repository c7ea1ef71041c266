#include "app/workspaces/device/device_panel.h"

#include "app/workspaces/device/pace_row.h"
#include "app/workspaces/device/simulation_options_dialog.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/side_columns.h"
#include "devices/device_uri.h"
#include "devices/open/device_title.h"
#include "devices/open/open_device.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

} // namespace

DevicePanel::DevicePanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* page = makeScrollingColumn(this);
    m_columns = new SideColumns(this);
    page->addWidget(m_columns);
    page->addStretch(1);
    auto* own = new QWidget(m_columns);
    own->setObjectName(QStringLiteral("device_chooser"));
    auto* column = new QVBoxLayout(own);
    column->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* devices = addSection(column, tr("Devices"), own);
    devices->setSpacing(widgets::PanelMargin_px);
    buildChooser(devices);
    buildIdentity(devices);
    constexpr int OwnShare = 5; // names of devices with their addresses are long
    m_columns->addPart(*own, OwnShare);
    setFocusProxy(m_list);
    takeDevices(devices::listBuiltInDevices());
    refresh();
    m_watcher =
        std::make_unique<devices::DeviceWatcher>([this](const std::vector<devices::DeviceListing>& list) {
            QMetaObject::invokeMethod(
                this, [this, list] { takeDevices(list); }, Qt::QueuedConnection);
        });
    DeviceSession& session = m_bench.session();
    connect(&session, &DeviceSession::stateChanged, this, &DevicePanel::refresh);
    connect(&session, &DeviceSession::connectFailed, this, &DevicePanel::onFailed);
    connect(&session, &DeviceSession::procedureChanged, this, &DevicePanel::refresh);
}

void DevicePanel::addPart(QWidget& part) {
    constexpr int Share = 4;
    m_columns->addPart(part, Share);
}

void DevicePanel::buildChooser(QVBoxLayout* column) {
    m_list = new QListWidget(this);
    m_list->setIconSize({16, 16});
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setAccessibleName(tr("Available devices"));
    m_list->setToolTip(tr("Enter or double-click connects"));
    m_address = new QLineEdit(this);
    m_address->setAccessibleName(tr("Device address"));
    m_address->setToolTip(tr("Example: sim:htm?seed=7 or tcp:HOST:PORT"));
    m_address->setPlaceholderText(tr("sim:htm or tcp:HOST:PORT"));
    m_description = new QPushButton(this);
    m_description->setIcon(widgets::themedIcon("open"));
    m_description->setAccessibleName(tr("Description file…"));
    m_description->setToolTip(
        tr("A2L file from the manufacturer, for boards without a built-in description"));
    m_description->hide(); // until there is a way to ask for a file
    m_options = new QPushButton(this);
    m_options->setIcon(widgets::themedIcon("settings"));
    m_options->setAccessibleName(tr("Simulation options…"));
    m_options->setToolTip(tr("Values of the simulated actuator: motion, noise, faults…"));
    m_connect = new QPushButton(this);
    m_connect->setIcon(widgets::themedIcon("connect"));
    m_message = new widgets::MessageBar(this);

    m_noneFound = makeNote(this);
    m_noneFound->setText(tr("No device found on USB or a serial port."));

    column->addWidget(m_list);
    column->addWidget(m_noneFound);
    auto* target = new QHBoxLayout;
    target->addWidget(m_address, 1);
    target->addWidget(m_options);
    target->addWidget(m_description);
    column->addLayout(target);
    column->addWidget(m_connect);
    layout()->addWidget(m_message); // below what scrolls, so that all its words are seen
    column->addWidget(new PaceRow(m_bench, PaceRow::Place::Devices, this));

    buildMenu();
    connect(m_list, &QListWidget::currentRowChanged, this, &DevicePanel::chooseRow);
    connect(m_address, &QLineEdit::textEdited, this, [this] { m_hasChosen = true; });
    connect(m_address, &QLineEdit::textChanged, this, &DevicePanel::offerOptions);
    connect(m_options, &QPushButton::clicked, this, &DevicePanel::editOptions);
    connect(m_list, &QListWidget::itemActivated, this, [this] { connectAddress(); });
    connect(m_address, &QLineEdit::returnPressed, this, &DevicePanel::connectAddress);
    connect(m_connect, &QPushButton::clicked, this, &DevicePanel::toggleConnection);
    connect(m_description, &QPushButton::clicked, this, &DevicePanel::chooseDescription);
}

void DevicePanel::buildMenu() {
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto add = [this](const QString& text, const auto& act) {
        auto* action = new QAction(text, m_list);
        connect(action, &QAction::triggered, this, act);
        m_list->addAction(action);
    };
    add(tr("Connect"), [this] { connectAddress(); });
    add(tr("Copy address"), [this] { QGuiApplication::clipboard()->setText(address()); });
}

void DevicePanel::buildIdentity(QVBoxLayout* column) {
    m_identity = new QLabel(this);
    m_identity->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_identity->setWordWrap(true);
    m_identity->setFocusPolicy(Qt::ClickFocus);
    m_identity->setAccessibleName(tr("Device identification"));
    m_identity->setToolTip(tr("Model, identity and firmware reported by the device"));
    column->addWidget(m_identity);
}

void DevicePanel::takeDevices(std::vector<devices::DeviceListing> list) {
    m_listed = std::move(list);
    showDevices();
}

/// Devices that come and go change neither what the user chose nor what was typed.
void DevicePanel::showDevices() {
    const QSignalBlocker quiet(m_list);
    const QListWidgetItem* current = m_list->currentItem();
    const QString chosen = current == nullptr ? QString() : current->data(Qt::UserRole).toString();
    const auto last = m_remembered.uri.empty()
                          ? m_remembered.uri
                          : devices::addressNow(m_remembered, m_listed).value_or(std::string());
    m_list->clear();
    m_noneFound->setVisible(std::all_of(m_listed.begin(), m_listed.end(),
                                        [](const auto& listing) { return listing.isSimulated; }));
    if (!last.empty()) {
        devices::DeviceListing listing;
        listing.uri = last;
        listing.id = m_remembered.serial;
        listing.isAvailable = true;
        const auto found =
            std::find_if(m_listed.begin(), m_listed.end(), [&](const auto& one) { return one.uri == last; });
        addDevice(found == m_listed.end() ? listing : *found, true);
    }
    for (const devices::DeviceListing& listing : m_listed) {
        if (listing.uri != last) {
            addDevice(listing, false);
        }
    }
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_hasChosen && m_list->item(row)->data(Qt::UserRole).toString() == chosen) {
            m_list->setCurrentRow(row);
        }
    }
    if (!m_hasChosen && m_list->count() > 0) {
        m_list->setCurrentRow(0);
        m_address->setText(m_list->item(0)->data(Qt::UserRole).toString());
    }
    markConnected();
    fitRows();
}

QListWidgetItem* DevicePanel::itemOf(const QString& uri) const {
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(Qt::UserRole).toString() == uri) {
            return m_list->item(row);
        }
    }
    return nullptr;
}

/// While one is connected its row is the current one, none when it is not in the list; by the user's choice
/// otherwise.
void DevicePanel::markConnected() {
    const DeviceSession& session = m_bench.session();
    const bool isBusy = session.state() != SessionState::Disconnected;
    if (!isBusy) {
        return;
    }
    const QSignalBlocker quiet(m_list);
    QListWidgetItem* connected = itemOf(words(session.info().uri));
    m_list->setCurrentItem(connected != nullptr ? connected : itemOf(address()));
}

/// As many whole rows as there are devices, from two to five: half a row looks like the last one.
void DevicePanel::fitRows() {
    constexpr int FewestRows = 2;
    constexpr int MostRows = 5;
    constexpr int MostAtOnce = 3; // of a small window; it can be scrolled
    const int row_px = std::max(m_list->sizeHintForRow(0), fontMetrics().height());
    const int frame_px = 2 * m_list->frameWidth();
    const auto height_px = [&](int most) {
        return std::clamp(m_list->count(), FewestRows, most) * row_px + frame_px;
    };
    m_list->setMinimumHeight(height_px(MostAtOnce));
    m_list->setMaximumHeight(height_px(MostRows));
}

void DevicePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fitRows();
}

/// Another dress has other rows.
void DevicePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (m_list != nullptr && (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)) {
        fitRows();
    }
}

/// A name to read, beside the address to type.
QString DevicePanel::textOf(const devices::DeviceListing& listing) {
    const QString uri = words(listing.uri);
    if (const std::string title = devices::simulatedTitle(listing.uri); !title.empty()) {
        return tr("%1, simulated (%2)").arg(widgets::inWords(title), uri);
    }
    return listing.name.empty() ? uri : QStringLiteral("%1 (%2)").arg(words(listing.name), uri);
}

void DevicePanel::addDevice(const devices::DeviceListing& listing, bool isLast) {
    const QString uri = words(listing.uri);
    const QString text = textOf(listing);
    auto* item = new QListWidgetItem(isLast ? tr("%1, last used").arg(text) : text, m_list);
    item->setData(Qt::UserRole, uri);
    item->setIcon(listing.isSimulated ? widgets::themedIcon("simulated", widgets::Role::Simulated)
                                      : widgets::themedIcon("connect"));
    item->setToolTip(listing.isAvailable ? words(listing.id)
                                         : widgets::inWords(listing.reason + ". " + listing.hint));
    if (!listing.isAvailable) {
        item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
    }
}

void DevicePanel::setRemembered(const devices::RememberedPort& port) {
    m_remembered = port;
    showDevices();
}

/// Only what a cable leads to: simulated devices are always there.
void DevicePanel::remember() {
    const devices::DeviceInfo& info = m_bench.session().info();
    if (!info.isSimulated && info.transport != "replay") {
        setRemembered(devices::rememberPort(info.uri, m_listed));
    }
}

void DevicePanel::chooseRow(int row) {
    if (const QListWidgetItem* item = m_list->item(row)) {
        m_address->setText(item->data(Qt::UserRole).toString());
        m_hasChosen = true;
    }
}

void DevicePanel::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    m_description->setVisible(bool(m_chooser.open));
}

/// Into the address, so that it is seen, remembered and changed like the rest of it.
void DevicePanel::chooseDescription() {
    const QString file =
        m_chooser.open(this, {tr("Description of the board"), {}, tr("Description (*.a2l)")});
    if (file.isEmpty()) {
        return;
    }
    const auto described = devices::withDescription(address().toStdString(), file.toStdString());
    if (!described) {
        onFailed(words(described.error().message), words(described.error().hint));
        return;
    }
    m_message->clear();
    setAddress(words(*described));
    m_connect->setFocus(Qt::OtherFocusReason);
}

void DevicePanel::offerOptions() {
    const bool isFree = m_bench.session().state() == SessionState::Disconnected;
    const bool isSimulated = devices::SimulationOptions::of(address().toStdString()).has_value();
    m_options->setVisible(isSimulated);
    m_options->setEnabled(isFree && isSimulated);
}

/// Into the address, as the description.
void DevicePanel::editOptions() {
    const auto options = devices::SimulationOptions::of(address().toStdString());
    if (!options) {
        return;
    }
    auto* dialog = new SimulationOptionsDialog(*options, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        m_message->clear();
        setAddress(dialog->address());
        m_connect->setFocus(Qt::OtherFocusReason);
    });
    dialog->open();
}

void DevicePanel::setAddress(const QString& uri) {
    m_hasChosen = true;
    m_address->setText(uri);
}

QString DevicePanel::address() const {
    return m_address->text().trimmed();
}

void DevicePanel::connectAddress() {
    m_message->clear();
    if (address().isEmpty()) {
        onFailed(tr("No device selected."), tr("Choose one from the list or enter its address."));
        return;
    }
    m_bench.session().connectDevice(address(), m_bench.pace());
}

void DevicePanel::toggleConnection() {
    if (m_bench.session().state() == SessionState::Disconnected) {
        connectAddress();
    } else if (!m_bench.session().heldDevice().isEmpty()) {
        m_bench.session().closeRecording();
    } else {
        m_bench.session().disconnectDevice();
    }
}

DevicePanel::ConnectWords DevicePanel::connectWords() const {
    const DeviceSession& session = m_bench.session();
    if (!session.heldDevice().isEmpty()) {
        return {tr("&Back"), tr("Close the recording, back to %1 (Alt+B)").arg(session.heldDevice())};
    }
    switch (session.state()) {
    case SessionState::Disconnected:
        return {tr("&Connect"), tr("Connect the device (Alt+C)")};
    case SessionState::Reconnecting:
        return {tr("Dis&connect"), tr("Stop searching for the device (Alt+C)")};
    default:
        return {tr("Dis&connect"), tr("Stop, disarm and disconnect (Alt+C)")};
    }
}

QList<QPair<QString, QString>> DevicePanel::devices() const {
    QList<QPair<QString, QString>> list;
    for (int row = 0; row < m_list->count(); ++row) {
        list << qMakePair(m_list->item(row)->text(), m_list->item(row)->data(Qt::UserRole).toString());
    }
    return list;
}

void DevicePanel::onFailed(const QString& text, const QString& hint) {
    m_message->showMessage({widgets::Severity::Error, widgets::inWords(text), widgets::inWords(hint), {}});
}

void DevicePanel::refresh() {
    const DeviceSession& session = m_bench.session();
    const bool isFree = session.state() == SessionState::Disconnected;
    m_list->setEnabled(isFree);
    m_address->setEnabled(isFree);
    m_description->setEnabled(isFree);
    offerOptions();
    m_connect->setEnabled(session.state() != SessionState::Leaving);
    const ConnectWords words = connectWords();
    m_connect->setText(words.text);
    m_connect->setIcon(widgets::themedIcon(isFree ? "connect" : "disconnect"));
    m_connect->setToolTip(words.tip);
    if (session.state() == SessionState::Connected) {
        remember();
    }
    if (session.state() == SessionState::Lost && session.report().lost) {
        onFailed(widgets::inWords(session.report().lost->message),
                 widgets::inWords(session.report().lost->hint));
    }
    m_identity->setText(identityText());
    markConnected();
}

QString DevicePanel::identityText() const {
    const DeviceSession& session = m_bench.session();
    if (session.state() == SessionState::Leaving) {
        return tr("Stopping and disarming…");
    }
    if (session.state() == SessionState::Reconnecting) {
        return tr("Connection lost. Reconnecting to %1…").arg(words(session.info().id));
    }
    if (session.state() != SessionState::Connected) {
        return {};
    }
    const devices::DeviceInfo& info = session.info();
    const QString name = words(!info.id.empty() ? info.id : !info.model.empty() ? info.model : info.uri);
    return tr("%1\nFirmware %2")
        .arg(name, info.firmware.empty() ? tr("not specified") : words(info.firmware));
}

} // namespace halbench::app
