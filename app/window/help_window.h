#pragma once

#include <QStringList>
#include <QWidget>

class QAction;
class QTextBrowser;

namespace halbench::app {

/// Text of a page of resources/help; empty when there is none of that name.
QString helpText(const QString& page);

/// The pages of resources/help, compiled in; links lead from page to page, Back returns. Carries a small
/// STOP.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    explicit HelpWindow(const QString& page, QWidget* parent = nullptr);
    /// `address`: a page, a page and a section of it ("identification.md#6-calibrations"), or "#section".
    void openPage(const QString& address);

Q_SIGNALS:
    void stopRequested();

private:
    void buildBar();
    void showPage(const QString& page);
    void showSection(const QString& anchor);
    void goBack();

    QTextBrowser* m_text = nullptr;
    QAction* m_back = nullptr;
    QStringList m_visited; ///< the last one is shown
};

} // namespace halbench::app
