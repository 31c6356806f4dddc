// Requirements of CiA 306, and deviations of real files: each deviation is read as intended, and
// reported.
#include "canvoy/formats/eds/eds_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "canvoy/formats/eds/eds_writer.hpp"

namespace canvoy::formats::eds_reader_test {
namespace {

class EdsReader : public testing::Test {
 protected:
  DataSheet read(std::string_view text) { return read_eds(text, findings_); }
  /// True if there is a finding for this line and section with these words in it.
  testing::AssertionResult found(std::size_t line, std::string_view section,
                                 std::string_view words) {
    std::string all;
    for (const Finding& finding : findings_) {
      if (finding.line == line && finding.section == section &&
          finding.text.find(words) != std::string::npos) {
        return testing::AssertionSuccess();
      }
      all += fmt::format("{} [{}] {}\n", finding.line, finding.section, finding.text);
    }
    return testing::AssertionFailure() << "only:\n" << all;
  }

  Findings findings_;
};

constexpr std::string_view variable =
    "[MandatoryObjects]\n"
    "SupportedObjects=1\n"
    "1=0x1000\n"
    "[1000]\n"
    "ParameterName=Device type\n"
    "ObjectType=0x7\n"
    "DataType=0x0007\n"
    "AccessType=ro\n"
    "DefaultValue=0x000201BF\n"
    "PDOMapping=0\n"
    "LowLimit=1\n"
    "HighLimit=0xFFFFFFFF\n"
    "ObjFlags=0x1\n"
    "[OptionalObjects]\nSupportedObjects=0\n[ManufacturerObjects]\nSupportedObjects=0\n";

TEST_F(EdsReader, ReadsAVariable) {
  const DataSheet sheet = read(variable);
  const SheetEntry* entry = sheet.find(0x1000, 0);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->name, "Device type");
  EXPECT_EQ(entry->object_type, 7U);
  EXPECT_EQ(entry->data_type, 7U);
  EXPECT_EQ(entry->access, "ro");
  EXPECT_EQ(sheet_number(entry->default_value)->number, 0x201BF);
  EXPECT_EQ(entry->low_limit, "1");
  EXPECT_EQ(entry->high_limit, "0xFFFFFFFF");
  EXPECT_EQ(entry->obj_flags, "0x1");
  EXPECT_FALSE(entry->pdo_mapping);
  EXPECT_EQ(sheet.objects.at(0x1000).group, SheetObject::Group::mandatory);
  EXPECT_FALSE(sheet.configured);
  EXPECT_TRUE(findings_.empty()) << findings_.front().text;
}

TEST_F(EdsReader, ReadsTheEntriesOfARecord) {
  const DataSheet sheet = read(
      "[1018]\nParameterName=Identity\nObjectType=0x9\nSubNumber=2\n"
      "[1018sub0]\nParameterName=count\nDataType=5\nAccessType=const\nDefaultValue=1\n"
      "[1018sub1]\nParameterName=Vendor-ID\nDataType=7\nAccessType=ro\nDefaultValue=0x123\n");
  EXPECT_EQ(sheet.objects.at(0x1018).subs.size(), 2U);
  EXPECT_EQ(sheet.find(0x1018, 1)->name, "Vendor-ID");
  EXPECT_EQ(sheet.find(0x1018, 2), nullptr);
}

TEST_F(EdsReader, ReadsSubIndicesAsHexadecimalInAnyCase) {
  const DataSheet sheet = read(
      "[2007]\nParameterName=many\nObjectType=8\n[2007Sub1]\nParameterName=a\nDataType=5\n"
      "[2007SUBfE]\nParameterName=b\nDataType=5\n");
  EXPECT_EQ(sheet.find(0x2007, 1)->name, "a");
  EXPECT_EQ(sheet.find(0x2007, 0xFE)->name, "b");
}

TEST_F(EdsReader, MeetsWindowsAndMacLinesAMarkOfByteOrderAndBlanksAroundAll) {
  const DataSheet sheet = read(
      "\xEF\xBB\xBF\r\n [ 1000 ] \r\n\tParameterName = Device type \r\nDataType = 0x7\r\n\r\n");
  EXPECT_EQ(sheet.find(0x1000, 0)->name, "Device type");
}

TEST_F(EdsReader, AnEmptyPdoMappingIsNone) {
  const DataSheet sheet = read("[6000]\nParameterName=x\nDataType=5\nPDOMapping=\n");
  EXPECT_FALSE(sheet.find(0x6000, 0)->pdo_mapping);
  EXPECT_TRUE(found(4, "6000", "PDOMapping is empty"));
}

TEST_F(EdsReader, AValueOverridesTheFormulaOfItsDefault) {
  const DataSheet sheet = read(
      "[1800]\nObjectType=9\n[1800sub1]\nParameterName=COB-ID\nDataType=7\n"
      "DefaultValue=$NODEID+0x180\nParameterValue=0x1A5\n");
  const SheetEntry* cob_id = sheet.find(0x1800, 1);
  EXPECT_EQ(sheet_number(cob_id->default_value), (SheetNumber{0x180, true}));
  EXPECT_EQ(sheet_number(cob_id->value), (SheetNumber{0x1A5, false}));
  EXPECT_TRUE(sheet.configured) << "an EDS has no values";
}

TEST_F(EdsReader, KeepsTheSectionsOfModules) {
  const DataSheet sheet =
      read("[M1SubExt6000]\nCount=1\nObjExtend=3\n[SupportedModules]\nNrOfEntries=1\n");
  EXPECT_EQ(sheet.text("M1SubExt6000", "ObjExtend"), "3");
  EXPECT_EQ(sheet.text("SupportedModules", "NrOfEntries"), "1");
  EXPECT_NE(write_eds(sheet).find("[M1SubExt6000]\r\nCount=1\r\nObjExtend=3\r\n"),
            std::string::npos);
}

TEST_F(EdsReader, ReadsABoolean) {
  const DataSheet sheet =
      read("[2000]\nParameterName=on\nObjectType=7\nDataType=0x0001\nDefaultValue=1\n");
  EXPECT_EQ(sheet.find(0x2000, 0)->data_type, 1U);
}

TEST_F(EdsReader, TakesAFileVersionAndAVendorNumberThatAreNone) {
  const DataSheet sheet = read("[FileInfo]\nFileVersion=-\n[DeviceInfo]\nVendorNumber=\n");
  EXPECT_EQ(sheet.text("FileInfo", "FileVersion"), "-");
  EXPECT_EQ(sheet.text("deviceinfo", "vendornumber"), "");
}

TEST_F(EdsReader, AnInvalidCobIdIsNotAnExtendedOne) {
  EXPECT_EQ(sheet_number("0x80000000")->number, 0x8000'0000);
  EXPECT_EQ(sheet_number("$NODEID+0x80000180")->at(5), 0x8000'0185);
}

TEST_F(EdsReader, ARecordThatIsCalledAnArrayHasItsEntries) {
  const DataSheet sheet = read(
      "[1018]\nParameterName=Identity\nObjectType=0x8\nSubNumber=2\n"
      "[1018sub0]\nParameterName=n\nDataType=5\n[1018sub1]\nParameterName=Vendor\nDataType=7\n");
  EXPECT_EQ(sheet.objects.at(0x1018).own.object_type, 8U) << "what it says is told by the check";
  EXPECT_EQ(sheet.find(0x1018, 1)->data_type, 7U);
}

TEST_F(EdsReader, AnImpossibleNumberOfObjectsIsTold) {
  for (const char* count : {"65535", "4294967296", "-1", "99999999999999999999"}) {
    findings_.clear();
    const DataSheet sheet = read(std::string("[OptionalObjects]\nSupportedObjects=") + count +
                                 "\n1=0x2000\n[2000]\nParameterName=x\nDataType=5\n");
    EXPECT_EQ(sheet.objects.size(), 1U) << count;
    EXPECT_TRUE(found(2, "OptionalObjects", std::string("SupportedObjects is ") + count) ||
                found(2, "OptionalObjects", std::string("SupportedObjects is '") + count));
  }
}

TEST_F(EdsReader, ReadsNumbersInEachNotation) {
  EXPECT_EQ(sheet_number("26")->number, 26);
  EXPECT_EQ(sheet_number("0x1A")->number, 26);
  EXPECT_EQ(sheet_number("0X1a")->number, 26);
  EXPECT_EQ(sheet_number("032")->number, 26) << "octal, as CiA 306 has it";
  EXPECT_EQ(sheet_number("08")->number, 8) << "no octal number, but people write it";
  EXPECT_EQ(sheet_number("-26")->number, -26);
  EXPECT_EQ(sheet_number(" $nodeid + 0x10 "), (SheetNumber{16, true}));
  EXPECT_EQ(sheet_number("0x10+$NODEID"), (SheetNumber{16, true}));
  EXPECT_EQ(sheet_number("$NODEID"), (SheetNumber{0, true}));
  EXPECT_EQ(sheet_number("0xFFFFFFFFFFFFFFFF")->number, -1);
  for (const char* text : {"", " ", "x", "0x", "1A", "1.5", "--1", "$NODE+1", "$NODEID-1",
                           "$NODEID+", "1+2", "0x10000000000000000"}) {
    EXPECT_FALSE(sheet_number(text)) << text;
  }
}

TEST_F(EdsReader, ExpandsAnArrayThatIsNotWrittenOut) {
  const DataSheet sheet = read(
      "[1003]\nParameterName=Error\nObjectType=8\nDataType=7\nAccessType=ro\nCompactSubObj=3\n"
      "DefaultValue=0x5\n[1003Value]\nNrOfEntries=1\n2=0x1234\n[1003Name]\nNrOfEntries=1\n3="
      "Oldest\n");
  EXPECT_EQ(sheet.objects.at(0x1003).subs.size(), 4U);
  EXPECT_EQ(sheet.find(0x1003, 0)->data_type, 5U);
  EXPECT_EQ(sheet.find(0x1003, 1)->name, "Error1");
  EXPECT_EQ(sheet.find(0x1003, 1)->default_value, "0x5");
  EXPECT_EQ(sheet.find(0x1003, 2)->value, "0x1234");
  EXPECT_EQ(sheet.find(0x1003, 3)->name, "Oldest");
}

TEST_F(EdsReader, AListNamesIndicesOf16Bits) {
  const DataSheet sheet = read(
      "[MandatoryObjects]\nSupportedObjects=2\n1=0x11000\n2=$NODEID+0x1001\n"
      "[1000]\nParameterName=a\n[1001]\nParameterName=b\n");
  EXPECT_TRUE(found(3, "MandatoryObjects", "'0x11000' has no section"));
  EXPECT_TRUE(found(4, "MandatoryObjects", "'$NODEID+0x1001' has no section"));
  EXPECT_EQ(sheet.objects.at(0x1000).group, SheetObject::Group::not_listed);
  EXPECT_EQ(sheet.objects.at(0x1001).group, SheetObject::Group::not_listed);
}

/// Each of 1,000 objects needs 254 entries with a name of 10,000 letters: 2.5 GB from 10 MB.
TEST_F(EdsReader, DoesNotExpandWhatNoMemoryHolds) {
  const std::string name(10'000, 'n');
  std::string text;
  for (unsigned index = 0x2000; index < 0x2000 + 1000; ++index) {
    text += fmt::format(
        "[{:04X}]\nParameterName={}\nObjectType=8\nDataType=5\n"
        "CompactSubObj=254\n",
        index, name);
  }
  const DataSheet sheet = read(text);
  std::size_t bytes = 0;
  for (const auto& [index, object] : sheet.objects) {
    for (const auto& [sub, entry] : object.subs) bytes += sizeof entry + entry.name.size();
  }
  EXPECT_LT(bytes, 70'000'000U);
  EXPECT_EQ(sheet.objects.at(0x2000).subs.size(), 255U) << "the first ones are";
  EXPECT_TRUE(found(5 * 999 + 5, "23E7", "CompactSubObj is 254"));
}

TEST_F(EdsReader, ManyFaultsAreNotAllTold) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "x\n";
  read(text + "[1000]\nParameterName=a\n");
  EXPECT_EQ(findings_.size(), 10'001U + 4) << "three lists, and an object that none names";
  EXPECT_EQ(findings_[10'000].text, "there are more faults like these than the 10000 told");
}

TEST_F(EdsReader, TellsWhatCannotBeUnderstood) {
  read(
      "what\n[1000]\nDataType=seven\nDataType=7\nodd\n[1000]\n[1001sub1]\nParameterName=x\n"
      "[OptionalObjects]\nSupportedObjects=2\n1=0x2000\n[2100]\nCompactSubObj=255\nSubNumber=3\n");
  EXPECT_TRUE(found(1, "", "'what' sets no key"));
  EXPECT_TRUE(found(3, "1000", "DataType is 'seven'"));
  EXPECT_TRUE(found(4, "1000", "DataType is set again"));
  EXPECT_TRUE(found(5, "1000", "'odd' sets no key"));
  EXPECT_TRUE(found(6, "1000", "second time"));
  EXPECT_TRUE(found(7, "1001sub1", "no object for this entry"));
  EXPECT_TRUE(found(11, "OptionalObjects", "'0x2000' has no section"));
  EXPECT_TRUE(found(10, "OptionalObjects", "SupportedObjects is 2"));
  EXPECT_TRUE(found(13, "2100", "CompactSubObj is 255"));
  EXPECT_TRUE(found(14, "2100", "SubNumber is 3"));
}

TEST_F(EdsReader, LosesNothingInARoundTrip) {
  constexpr std::string_view text =
      "; written by hand\r\n\r\n"
      "[FileInfo]\r\nFileName=a.eds\r\nMyKey=mine\r\n; a comment\r\n"
      "\r\n[DeviceInfo]\r\nVendorName=Somebody\r\n"
      "\r\n[DummyUsage]\r\nDummy0005=1\r\nDummy0006=0\r\n"
      "\r\n[Comments]\r\nLines=2\r\nLine1=one\r\nLine2=two\r\n"
      "\r\n[MandatoryObjects]\r\nSupportedObjects=0\r\n"
      "\r\n[OptionalObjects]\r\nSupportedObjects=1\r\n1=0x6000\r\n"
      "\r\n[6000]\r\nParameterName=Door\r\nObjectType=0x9\r\nSubNumber=1\r\nMyRecordKey=1\r\n"
      "; of the left side\r\n"
      "\r\n[6000sub0]\r\nParameterName=count\r\nObjectType=0x7\r\nDataType=0x0005\r\nAccessType="
      "rwr\r\n"
      "DefaultValue=0x0A\r\nLowLimit=0\r\nHighLimit=10\r\nPDOMapping=1\r\nObjFlags="
      "0x2\r\nMyEntryKey=2\r\n"
      "\r\n[ManufacturerObjects]\r\nSupportedObjects=0\r\n"
      "\r\n[Tools]\r\nItems=1\r\n";
  EXPECT_EQ(write_eds(read(text)), text);
}

TEST_F(EdsReader, ReadsAnything) {
  for (const char* text :
       {"", "\n", "[", "[]", "=", "==", "[1000", "]", "[1000]", "[10000]", "[10]", "[1000sub]",
        "[1000sub100]", "[1000subx]", "[1003Value]\n1=2\n", "[DummyUsage]\nDummy=1\nDummyX=1\n",
        "[MandatoryObjects]\n1=$NODEID\n"}) {
    const DataSheet sheet = read(text);
    read(write_eds(sheet));
  }
}

TEST_F(EdsReader, ALineWithoutAKeyBeginsNoSectionWhenItIsWrittenAgain) {
  const DataSheet sheet =
      read("[1800]\nParameterName=TPDO\nObjectType=9\n=[1800sub0]\nDataType=5\n");
  EXPECT_EQ(sheet.objects.at(0x1800).subs.size(), 0U);
  EXPECT_EQ(read(write_eds(sheet)).objects.at(0x1800).subs.size(), 0U);
}

// What was made from modules and CompactPDO is written out, and not made again.
TEST(EdsModules, AreMadeOnce) {
  constexpr std::string_view text =
      "[DeviceInfo]\nCompactPDO=3\nNrOfRXPDO=1\nNrOfTXPDO=1\n[1000]\nParameterName=Type\n"
      "DataType=7\nAccessType=ro\n[ConnectedModules]\nNrOfEntries=2\n1=1\n2=1\n"
      "[M1Fixed2100]\nParameterName=Filter\nDataType=6\nAccessType=rw\n"
      "[M1SubExt6000]\nParameterName=Input\nDataType=5\nAccessType=ro\nCount=2\n";
  Findings findings;
  DataSheet first = read_eds(text, findings);
  EXPECT_EQ(first.objects.at(0x6000).subs.size(), 5U);
  EXPECT_EQ(first.objects.size(), 7U);
  first.objects.at(0x2100).own.value = "7";
  first.configured = true;
  findings.clear();
  const DataSheet second = read_eds(write_eds(first), findings);
  EXPECT_EQ(second.objects.at(0x6000).subs.size(), 5U);
  EXPECT_EQ(second.objects.size(), first.objects.size());
  EXPECT_EQ(second.objects.at(0x2100).own.value, "7");
}

/// The number of a module is of digits alone: M1.Fixed2100 is a section of another tool.
TEST(EdsModules, AreNamedByDigits) {
  for (const unsigned module : {1U, 8U}) {
    const std::string text = "[ConnectedModules]\nNrOfEntries=1\n1=" + std::to_string(module) +
                             "\n[M1.Fixed2100]\nParameterName=Filter\nDataType=6\n";
    Findings findings;
    EXPECT_FALSE(read_eds(text, findings).objects.contains(0x2100)) << module;
  }
}

/// Sub-indices of entries are 1 to 254 (CiA 301, 7.4.7.1).
TEST(EdsModules, MakeAsManyEntriesAsAnObjectHas) {
  for (const std::size_t count : {1U, 254U, 255U, 0U}) {
    const std::string text =
        "[ConnectedModules]\nNrOfEntries=1\n1=1\n[M1SubExt6000]\nParameterName=Input\n"
        "DataType=5\nAccessType=ro\nCount=" +
        std::to_string(count) + "\n";
    Findings findings;
    const DataSheet sheet = read_eds(text, findings);
    const bool is_possible = count == 1 || count == 254;
    ASSERT_EQ(sheet.objects.contains(0x6000), is_possible) << count;
    if (is_possible) {
      EXPECT_EQ(sheet.objects.at(0x6000).subs.size(), count + 1) << "and the number";
    }
  }
}

}  // namespace
}  // namespace canvoy::formats::eds_reader_test
