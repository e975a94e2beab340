// SPDX-License-Identifier: GPL-3.0-or-later

// The code of tinygltf without images and files: both are left to its caller.

#include <fstream> // which it uses nevertheless

#define TINYGLTF_IMPLEMENTATION
#include "read/tinygltf.h"
