// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The colours of all pictures: Okabe and Ito's, which colour-blind people can tell apart, on quiet
// greys.
#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace sbox::palette {

using Colour = cv::Vec3b;  ///< Blue, green, red: OpenCV's order.

inline const Colour paper{255, 255, 255};
inline const Colour ink{51, 43, 38};
inline const Colour quiet_ink{130, 122, 115};
inline const Colour frame{205, 200, 196};

inline const Colour unknown{241, 238, 235};
inline const Colour free_space{255, 255, 255};
inline const Colour wall{85, 78, 72};
inline const Colour soft_wall{168, 161, 154};

inline const Colour blue{178, 114, 0};
inline const Colour orange{0, 159, 230};
inline const Colour green{115, 158, 0};
inline const Colour vermillion{0, 94, 213};
inline const Colour magenta{127, 0, 208};

inline const Colour free_of_a{250, 236, 218};
inline const Colour free_of_b{214, 238, 254};
inline const Colour free_of_both{255, 255, 255};
inline const Colour agreeing_wall{40, 34, 30};

/// For things that belong together in pairs.
inline const std::array<Colour, 7> distinct{blue,
                                            vermillion,
                                            green,
                                            Colour{167, 90, 180},
                                            Colour{220, 170, 60},
                                            Colour{0, 140, 200},
                                            Colour{90, 90, 90}};

/// The colour as OpenCV's functions take it.
inline cv::Scalar scalar(const Colour& colour) {
  return {1. * colour[0], 1. * colour[1], 1. * colour[2]};
}

}  // namespace sbox::palette
