#pragma once

#include <string_view>

namespace treeline::package_templates {

// Files of templates/packages/, embedded when the generator is built.
extern const std::string_view kArduinoExample;
extern const std::string_view kArduinoKeywords;
extern const std::string_view kArduinoLibrary;
extern const std::string_view kCMakeLists;
extern const std::string_view kCmsisPack;
extern const std::string_view kFirmwareCan;
extern const std::string_view kFirmwareCanHeader;
extern const std::string_view kFirmwareMain;
extern const std::string_view kFirmwareMakefile;
extern const std::string_view kFirmwareMemory;
extern const std::string_view kFirmwarePort;
extern const std::string_view kFirmwarePortQemu;
extern const std::string_view kFirmwareReadme;
extern const std::string_view kFmuBuildDescription;
extern const std::string_view kFmuCMakeLists;
extern const std::string_view kFmuController;
extern const std::string_view kFmuDifferentiate;
extern const std::string_view kFmuExporting;
extern const std::string_view kFmuModel;
extern const std::string_view kFmuModelDescription2;
extern const std::string_view kFmuModelDescription3;
extern const std::string_view kFmuModelExchange2;
extern const std::string_view kFmuModelExchange3;
extern const std::string_view kFmuNoDerivatives;
extern const std::string_view kFmuPlatform2;
extern const std::string_view kFmuPlatform3;
extern const std::string_view kFmuUnits;
extern const std::string_view kFmuWrapper2;
extern const std::string_view kFmuWrapper3;
extern const std::string_view kPlatformioLibrary;
extern const std::string_view kPythonBuild;
extern const std::string_view kPythonDoc;
extern const std::string_view kPythonExample;
extern const std::string_view kPythonFunctions;
extern const std::string_view kPythonInit;
extern const std::string_view kPythonLoopStates;
extern const std::string_view kPythonManifest;
extern const std::string_view kPythonModule;
extern const std::string_view kPythonNumpyArrays;
extern const std::string_view kPythonOperands;
extern const std::string_view kPythonProject;
extern const std::string_view kPythonReadme;
extern const std::string_view kPythonSetup;
extern const std::string_view kPythonController;
extern const std::string_view kPythonLimited;
extern const std::string_view kPythonStructs;
extern const std::string_view kPythonStructsHeader;
extern const std::string_view kPythonTypes;
extern const std::string_view kRosCMakeLists;
extern const std::string_view kRosControllers;
extern const std::string_view kRosGravityLaw;
extern const std::string_view kRosMovePoint;
extern const std::string_view kRosPackage;
extern const std::string_view kRosParameters;
extern const std::string_view kRosPlugin;
extern const std::string_view kRosPluginDescription;
extern const std::string_view kRosPointParameters;
extern const std::string_view kRosReadme;
extern const std::string_view kRosStepLaw;
extern const std::string_view kRosStepParameters;
extern const std::string_view kRosTopics;
extern const std::string_view kRustBuild;
extern const std::string_view kRustLibrary;
extern const std::string_view kRustManifest;
extern const std::string_view kWasmBuild;
extern const std::string_view kWasmModule;
extern const std::string_view kWasmPackage;
extern const std::string_view kWasmTypes;
extern const std::string_view kZephyrCMakeLists;
extern const std::string_view kZephyrKconfig;
extern const std::string_view kZephyrModule;

}  // namespace treeline::package_templates
