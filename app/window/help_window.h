#pragma once

#include <QWidget>

class QTextBrowser;

namespace halbench::app {

/// Text of a page of resources/help; empty when there is none of that name.
QString helpText(const QString& page);

/// The pages of resources/help, compiled in; links lead from page to page.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    explicit HelpWindow(const QString& page, QWidget* parent = nullptr);
    void openPage(const QString& page);

private:
    QTextBrowser* m_text = nullptr;
};

} // namespace halbench::app
