// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The style and the script of a page, which is one file without anything from elsewhere.
#pragma once

namespace sbox::html {

/// CSS: light and dark by the reader's wish, or by the page's own button.
[[nodiscard]] const char* pageStyle();

/// JavaScript: the controls of the viewers. Without it all layers show.
[[nodiscard]] const char* pageScript();

}  // namespace sbox::html
