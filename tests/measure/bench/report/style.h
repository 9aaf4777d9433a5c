// The page's style sheet.
#ifndef REPORT_STYLE_H
#define REPORT_STYLE_H

extern const char page_style[];

#endif
