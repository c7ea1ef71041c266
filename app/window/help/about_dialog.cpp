#include "app/window/help/about_dialog.h"

#include "widgets/controls/stop_button.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

#include <Eigen/Core>

namespace halbench::app {

QString aboutText() {
    const QString eigen =
        QStringLiteral("%1.%2.%3").arg(EIGEN_WORLD_VERSION).arg(EIGEN_MAJOR_VERSION).arg(EIGEN_MINOR_VERSION);
    return QStringLiteral("Halbench %1\nQt %2, Eigen %3\n%4, %5")
        .arg(QStringLiteral(HALBENCH_VERSION), QString::fromLatin1(qVersion()), eigen,
             QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture());
}

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("About Halbench"));
    auto* purpose = new QLabel(tr("Workstation for precision Lorentz-force actuators: watch, calibrate, "
                                  "identify, tune, verify and record."),
                               this);
    purpose->setWordWrap(true);
    auto* versions = new QLabel(aboutText(), this);
    versions->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    versions->setAccessibleName(tr("Versions"));
    auto* licence =
        new QLabel(tr("Free software, GNU General Public License, version 3. No warranty."), this);
    licence->setWordWrap(true);
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, this);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close (Esc, which also stops)"));
    QPushButton* copy = buttons->addButton(tr("Co&py"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copy the versions for a fault report"));
    auto* row = new QHBoxLayout;
    row->addWidget(stop);
    row->addStretch(1);
    row->addWidget(buttons);
    auto* column = new QVBoxLayout(this);
    for (QLabel* label : {purpose, versions, licence}) {
        column->addWidget(label);
    }
    column->addLayout(row);
    setMinimumWidth(fontMetrics().averageCharWidth() * 60);
    connect(copy, &QPushButton::clicked, this, [] { QGuiApplication::clipboard()->setText(aboutText()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(stop, &widgets::StopButton::stopRequested, this, &AboutDialog::stopRequested);
}

} // namespace halbench::app
