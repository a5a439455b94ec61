// Stands in for pluginlib: one plugin a library, which a function makes.
#pragma once

#define PLUGINLIB_EXPORT_CLASS(Class, Base) \
  extern "C" Base* make_plugin();           \
  extern "C" Base* make_plugin() {          \
    return new Class;                       \
  }
